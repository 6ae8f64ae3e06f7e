#include "cs550/hill_climbing.hpp"
#include "drawing/climb_drawing.hpp"
#include "figure.hpp"
#include "sketch.hpp"

namespace cs550::book {
namespace {

Page climb_path() {
  const ShapePtr sphere = shape_of(icosphere_soup(2, 1));
  const Vec3 direction = Vec3(Real(0.35), Real(-0.35), 1).normalized();
  const Index start =
      support_brute_force(sphere->mesh.vertices, Vec3(Real(-0.5), -1, Real(-0.9))).vertex;
  std::vector<Index> path;
  hill_climb(sphere->mesh, direction, start, &path);
  Drawing sketch = drawing::draw_climb(sphere->mesh, direction, path);
  sketch.title.clear();
  return page_of(sketch, {}, {620, 500});
}

/// The corner of a polygon that is best by a measure.
template <class Measure>
const Vec3& best_of(const std::vector<Vec3>& corners, Measure measure) {
  return *std::max_element(corners.begin(), corners.end(),
                           [&](const Vec3& a, const Vec3& b) { return measure(a) < measure(b); });
}

Page distance_not_dot() {
  const std::vector<Vec3> needle = {at(-1.6, -0.35), at(0.2, -0.55), at(3.4, -0.5), at(0.6, 0.5),
                                    at(-1.2, 0.6)};
  const Vec3 direction = at(-0.35, 1).normalized();
  const Vec3& farthest = best_of(needle, [](const Vec3& p) { return p.norm(); });
  const Vec3& extreme = best_of(needle, [&](const Vec3& p) { return p.dot(direction); });
  Drawing sketch;
  add_area(sketch, needle, Role::Faint, 0.5);
  add_dot(sketch, at(0, 0), Role::Text, "origin");
  add_line(sketch, at(0, 0), farthest, {Role::Got, 2, true});
  add_dot(sketch, farthest, Role::Got, "farthest from the origin", 6);
  add_dot(sketch, extreme, Role::BodyA, "most extreme along d", 6);
  const Vec3 across = at(direction.y(), -direction.x());
  add_line(sketch, extreme - Real(1.2) * across, extreme + Real(2.6) * across,
           {Role::BodyA, 1.5f, true});
  add_line(sketch, at(0, 0), direction, {Role::Axis, 3, false, true}, "d");
  return page_of(sketch, drawing::view_from_above(), {640, 300});
}

Page local_maximum() {
  const std::vector<Vec3> outline = {at(-3, -1),    at(3, -1),     at(2.6, 0.6),
                                     at(1.9, 1.7),  at(1.2, 0.9),  at(0.2, 0.1),
                                     at(-0.9, 0.5), at(-1.6, 0.9), at(-2.4, 0.2)};
  Drawing sketch;
  // Two convex halves: a polygon of a drawing is convex.
  sketch.polygons.push_back(
      {{outline[0], outline[1], outline[5], outline[6], outline[7], outline[8]},
       Role::Faint,
       Real(0.6)});
  sketch.polygons.push_back(
      {{outline[1], outline[2], outline[3], outline[4], outline[5]}, Role::Faint, Real(0.6)});
  add_outline(sketch, outline, {Role::Text, 1.5f});
  for (const auto& [from, to] : {std::pair(0, 8), {8, 7}}) {
    add_line(sketch, outline[from], outline[to], {Role::Got, 3, false, true});
  }
  add_dot(sketch, outline[0], Role::Got, "start", 5);
  add_dot(sketch, outline[7], Role::Got, "no neighbour is higher", 6);
  add_dot(sketch, outline[3], Role::BodyA, "the highest vertex", 6);
  add_line(sketch, at(3.6, -0.8), at(3.6, 0.6), {Role::Axis, 3, false, true}, "d");
  return page_of(sketch, drawing::view_from_above(), {640, 300});
}

}  // namespace

std::vector<Figure> climbing_figures() {
  return {{"climb_path", climb_path},
          {"distance_not_dot", distance_not_dot},
          {"local_maximum", local_maximum}};
}

}  // namespace cs550::book
