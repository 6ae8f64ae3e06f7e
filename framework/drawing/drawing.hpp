#pragma once
/// @file drawing.hpp
/// What a stage of the pipeline looks like, as plain values: points, lines, polygons, balls, labels.
/// Functions beside this header make drawings from values of the contract; svg.hpp and the viewer
/// show them. Nothing here knows a window or a file.

#include <span>
#include <string>
#include <vector>

#include "cs550/math.hpp"
#include "drawing/palette.hpp"

namespace cs550::drawing {

/// A dot of constant size on the page.
struct Point {
  Vec3 position = Vec3::Zero();  ///< m
  Role role = Role::Text;        ///< what it stands for
  Real radius = 4;               ///< of the dot (pixels)
};

/// How a line looks.
struct Stroke {
  Role role = Role::Text;  ///< what it stands for
  Real width = 2;          ///< pixels
  bool dashed = false;     ///< so that colour is not the only difference
  bool arrow = false;      ///< a head at the end
};

/// A straight line.
struct Line {
  Vec3 from = Vec3::Zero();  ///< m
  Vec3 to = Vec3::Zero();    ///< m
  Stroke stroke;             ///< how it looks
};

/// A flat convex polygon.
struct Polygon {
  std::vector<Vec3> corners;  ///< counter-clockwise seen from its front (m)
  Role role = Role::Faint;    ///< what it stands for
  Real opacity = 1;           ///< 0 invisible – 1 opaque
};

/// A sphere: the ground of a Gauss map.
struct Ball {
  Vec3 center = Vec3::Zero();  ///< m
  Real radius = 1;             ///< m
  Role role = Role::Faint;     ///< what it stands for
  Real opacity = 1;            ///< 0 invisible – 1 opaque
};

/// Text beside a point of space.
struct Label {
  Vec3 position = Vec3::Zero();  ///< m
  std::string text;              ///< UTF-8, one line
  Role role = Role::Text;        ///< what it stands for
};

/// What stands in the legend beside its text.
enum class LegendMark : std::uint8_t { Line, Patch, Dot };

/// One entry of the legend.
struct LegendEntry {
  std::string text;                    ///< what is drawn like this
  Stroke stroke;                       ///< how it is drawn
  LegendMark mark = LegendMark::Line;  ///< a line, a face or a point
};

/// A picture before it has a point of view.
struct Drawing {
  std::string title;                ///< a few words
  std::string alt_text;             ///< what is to be seen, for those who cannot see it
  std::vector<Point> points;        ///< dots
  std::vector<Line> lines;          ///< edges, arcs in pieces, arrows
  std::vector<Polygon> polygons;    ///< faces
  std::vector<Ball> balls;          ///< spheres
  std::vector<Label> labels;        ///< text in space
  std::vector<LegendEntry> legend;  ///< what the colours mean here
  std::vector<std::string> notes;   ///< sentences below the picture
};

/// Adds the elements, legend and notes of another drawing; title and alt text stay.
void append(Drawing& drawing, const Drawing& other);

/// The same drawing elsewhere: every position is moved by a pose.
Drawing transformed(Drawing drawing, const Pose& pose);

/// A line through several points. A dashed one leaves out every second piece; an arrow has its head
/// at the end.
void add_curve(Drawing& drawing, std::span<const Vec3> points, const Stroke& stroke);
/// The same, and back to the first point.
void add_closed_curve(Drawing& drawing, std::span<const Vec3> points, const Stroke& stroke);

/// An arrow from a point along a vector.
void add_arrow(Drawing& drawing, const Vec3& from, const Vec3& vector, const Stroke& stroke,
               const std::string& label = "");

/// The box that holds all elements with finite coordinates.
Bounds bounds(const Drawing& drawing);
/// The box that holds them all.
Bounds bounds(std::span<const Drawing> drawings);

/// The elements whose coordinates are finite numbers. If any is not, a note says how many were left
/// out: values of unfinished code may be anything.
Drawing finite_part(const Drawing& drawing);

/// Whether the three coordinates are numbers, and their squares as well.
bool is_finite(const Vec3& position);

/// The mean of some positions; zero of none.
Vec3 middle(std::span<const Vec3> positions);

}  // namespace cs550::drawing
