#include "sketch.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cs550::book {
namespace {

Real turn_of(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - b).z(); }

/// Half of the hull: the chain that always turns left (Andrew 1979).
template <class Iterator>
void add_chain(std::vector<Vec3>& hull, Iterator first, Iterator last) {
  const std::size_t start = hull.size();
  for (; first != last; ++first) {
    while (hull.size() >= start + 2 && turn_of(hull[hull.size() - 2], hull.back(), *first) <= 0) {
      hull.pop_back();
    }
    hull.push_back(*first);
  }
  hull.pop_back();
}

}  // namespace

std::vector<Vec3> regular_polygon(int sides, const Vec3& middle, double radius, double turn) {
  std::vector<Vec3> corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = turn + 2 * M_PI * i / sides;
    corners.push_back(middle + at(radius * std::cos(angle), radius * std::sin(angle)));
  }
  return corners;
}

std::vector<Vec3> flat_hull(std::vector<Vec3> points) {
  std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  std::vector<Vec3> hull;
  add_chain(hull, points.begin(), points.end());
  add_chain(hull, points.rbegin(), points.rend());
  return hull;
}

void add_area(Drawing& sketch, const std::vector<Vec3>& corners, Role role, double opacity) {
  sketch.polygons.push_back({corners, role, static_cast<Real>(opacity)});
  add_outline(sketch, corners, {role, 2});
}

void add_outline(Drawing& sketch, const std::vector<Vec3>& corners, const Stroke& stroke) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sketch.lines.push_back({corners[i], corners[(i + 1) % corners.size()], stroke});
  }
}

void add_dot(Drawing& sketch, const Vec3& position, Role role, const std::string& label,
             double radius) {
  sketch.points.push_back({position, role, static_cast<Real>(radius)});
  if (!label.empty()) sketch.labels.push_back({position, label, role});
}

void add_line(Drawing& sketch, const Vec3& from, const Vec3& to, const Stroke& stroke,
              const std::string& label) {
  sketch.lines.push_back({from, to, stroke});
  if (!label.empty()) sketch.labels.push_back({Real(0.5) * (from + to), label, stroke.role});
}

Page page_of(const Drawing& sketch, const View& view, const Size& size) {
  return page_of(std::vector<Drawing>{sketch}, view, size);
}

Page page_of(const std::vector<Drawing>& sketches, const View& view, const Size& size) {
  Page page;
  for (const Drawing& sketch : sketches) page.panels.emplace_back(Scene{sketch, view});
  page.panel_size = size;
  return page;
}

ShapePtr shape_of(const TriangleSoup& soup) {
  const ShapeResult result = make_shape(soup.vertices, soup.triangles);
  if (!result) throw std::runtime_error(result.error);
  return result.shape;
}

ShapePtr box(const Vec3& half_extents) { return shape_of(box_soup(half_extents)); }

ShapePtr random_hull(int vertices, std::uint32_t seed) {
  const SoupResult hull = convex_hull(random_sphere_points(vertices, seed));
  if (!hull.error.empty()) throw std::runtime_error(hull.error);
  return shape_of(hull.soup);
}

double Sequence::next() {
  state_ = state_ * 1664525U + 1013904223U;  // Knuth's line, Numerical Recipes' numbers
  return static_cast<double>(state_ >> 8) / 16777216.0;
}

Vec3 Sequence::direction() {
  const double z = 2 * next() - 1;
  const double angle = 2 * M_PI * next();
  const double radius = std::sqrt(1 - z * z);
  return Vec3(static_cast<Real>(radius * std::cos(angle)),
              static_cast<Real>(radius * std::sin(angle)), static_cast<Real>(z));
}

Quat Sequence::orientation() {
  const Vec3 axis = direction();
  return rotation_exp(static_cast<Real>(2 * M_PI * next()) * axis);
}

}  // namespace cs550::book
