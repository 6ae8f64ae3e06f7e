#pragma once
/// @file drawing.hpp
/// Pictures of the pipeline's stages as plain values: points, lines, polygons, balls, labels. The
/// other headers in this folder make drawings from values of the contract. svg.hpp and the viewer
/// show them. No drawing depends on a window or a file.

#include <span>
#include <string>
#include <vector>

#include "cs550/math.hpp"
#include "drawing/palette.hpp"

namespace cs550::drawing {

/// A dot whose size on the page is constant.
struct Point {
  Vec3 position = Vec3::Zero();  ///< m
  Role role = Role::Text;        ///< its meaning
  Real radius = 4;               ///< of the dot (pixels)
};

/// The style of a line.
struct Stroke {
  Role role = Role::Text;  ///< its meaning
  Real width = 2;          ///< pixels
  bool dashed = false;     ///< so that colour is not the only difference
  bool arrow = false;      ///< with an arrowhead at the end
};

/// A straight line.
struct Line {
  Vec3 from = Vec3::Zero();  ///< m
  Vec3 to = Vec3::Zero();    ///< m
  Stroke stroke;             ///< its style
};

/// A flat convex polygon.
struct Polygon {
  std::vector<Vec3> corners;  ///< counter-clockwise seen from the front (m)
  Role role = Role::Faint;    ///< its meaning
  Real opacity = 1;           ///< 0 invisible – 1 opaque
};

/// A sphere, such as that of a Gauss map.
struct Ball {
  Vec3 center = Vec3::Zero();  ///< m
  Real radius = 1;             ///< m
  Role role = Role::Faint;     ///< its meaning
  Real opacity = 1;            ///< 0 invisible – 1 opaque
};

/// Text beside a point in space.
struct Label {
  Vec3 position = Vec3::Zero();  ///< m
  std::string text;              ///< UTF-8, one line
  Role role = Role::Text;        ///< its meaning
};

/// The symbol beside the text of a legend entry.
enum class LegendMark : std::uint8_t { Line, Patch, Dot };

/// One entry of the legend.
struct LegendEntry {
  std::string text;                    ///< the meaning of the symbol
  Stroke stroke;                       ///< its style
  LegendMark mark = LegendMark::Line;  ///< a line, a face or a point
};

/// A picture in 3D, without a view.
struct Drawing {
  std::string title;                ///< a few words
  std::string alt_text;             ///< a description for readers who cannot see it
  std::vector<Point> points;        ///< dots
  std::vector<Line> lines;          ///< edges, arcs in pieces, arrows
  std::vector<Polygon> polygons;    ///< faces
  std::vector<Ball> balls;          ///< spheres
  std::vector<Label> labels;        ///< text in space
  std::vector<LegendEntry> legend;  ///< the meaning of the colours
  std::vector<std::string> notes;   ///< sentences below the picture
};

/// Adds the elements, legend and notes of another drawing. Title and alt text are kept.
void append(Drawing& drawing, const Drawing& other);

/// The drawing with all positions transformed by a pose.
Drawing transformed(Drawing drawing, const Pose& pose);

/// A line through several points. If it is dashed, every second piece is left out. An arrowhead is
/// at the end.
void add_curve(Drawing& drawing, std::span<const Vec3> points, const Stroke& stroke);
/// The same, closed.
void add_closed_curve(Drawing& drawing, std::span<const Vec3> points, const Stroke& stroke);

/// An arrow from a point along a vector.
void add_arrow(Drawing& drawing, const Vec3& from, const Vec3& vector, const Stroke& stroke,
               const std::string& label = "");

/// The bounds of all elements with finite coordinates.
Bounds bounds(const Drawing& drawing);
/// The bounds of some positions.
Bounds bounds(std::span<const Drawing> drawings);

/// The elements with finite coordinates, and a note with the number of elements left out.
/// Unfinished code may return any value.
Drawing finite_part(const Drawing& drawing);

/// Whether the coordinates and their squares are finite.
bool is_finite(const Vec3& position);

/// The mean of some positions, or zero if there are none.
Vec3 middle(std::span<const Vec3> positions);

}  // namespace cs550::drawing
