#pragma once
/// @file sketch.hpp
/// Flat drawings, and the shapes that figures are about.

#include <vector>

#include "cs550/convex_shape.hpp"
#include "cs550/primitives.hpp"
#include "drawing/svg.hpp"

namespace cs550::book {

using drawing::Drawing;
using drawing::Page;
using drawing::Role;
using drawing::Scene;
using drawing::Size;
using drawing::Stroke;
using drawing::View;

/// A point of the page.
inline Vec3 at(double x, double y) { return {static_cast<Real>(x), static_cast<Real>(y), 0}; }

/// The corners of a regular polygon, counter-clockwise.
std::vector<Vec3> regular_polygon(int sides, const Vec3& middle, double radius, double turn = 0);
/// The convex hull of points of the page, counter-clockwise.
std::vector<Vec3> flat_hull(std::vector<Vec3> points);

/// A filled polygon with its outline.
void add_area(Drawing& sketch, const std::vector<Vec3>& corners, Role role, double opacity = 0.6);
/// The outline alone.
void add_outline(Drawing& sketch, const std::vector<Vec3>& corners, const Stroke& stroke);
void add_dot(Drawing& sketch, const Vec3& position, Role role, const std::string& label = "",
             double radius = 4);
void add_line(Drawing& sketch, const Vec3& from, const Vec3& to, const Stroke& stroke,
              const std::string& label = "");

/// One picture, from above unless said otherwise.
Page page_of(const Drawing& sketch, const View& view = drawing::view_from_above(),
             const Size& size = {640, 360});
/// Two or more side by side.
Page page_of(const std::vector<Drawing>& sketches, const View& view, const Size& size);

/// Shapes by the contract. @throws std::runtime_error with the sentence of a refused mesh
ShapePtr shape_of(const TriangleSoup& soup);
ShapePtr box(const Vec3& half_extents);
/// The hull of random points on a sphere.
ShapePtr random_hull(int vertices, std::uint32_t seed);

/// A repeatable sequence of numbers in [0, 1).
class Sequence {
 public:
  explicit Sequence(std::uint32_t seed) : state_(seed) {}
  double next();
  Vec3 direction();
  Quat orientation();

 private:
  std::uint32_t state_;
};

}  // namespace cs550::book
