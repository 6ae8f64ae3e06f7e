#include "cs550/separating_axis.hpp"
#include "drawing/gauss_map_drawing.hpp"
#include "figure.hpp"
#include "sketch.hpp"

namespace cs550::book {
namespace {

struct Shadow {
  Real low = HUGE_VALF;
  Real high = -HUGE_VALF;
};

Shadow shadow_of(const std::vector<Vec3>& corners, const Vec3& axis) {
  Shadow shadow;
  for (const Vec3& corner : corners) {
    shadow.low = std::min(shadow.low, corner.dot(axis));
    shadow.high = std::max(shadow.high, corner.dot(axis));
  }
  return shadow;
}

Page shadows() {
  const std::vector<Vec3> a = {at(-3, 0), at(-1.2, -0.4), at(-0.4, 1), at(-1.4, 2), at(-2.8, 1.5)};
  const std::vector<Vec3> b = {at(0.2, 0.9), at(1.4, -0.5), at(2.8, 0.2), at(2.5, 1.9),
                               at(0.9, 2.2)};
  const Vec3 n = at(1, -0.12).normalized();
  const Vec3 down = at(-n.y() - 0.24, -n.x()).normalized();
  const Vec3 ground = Real(1.6) * down;
  Drawing sketch;
  add_area(sketch, a, Role::BodyA, 0.45);
  add_area(sketch, b, Role::BodyB, 0.45);
  const auto on_axis = [&](Real s) { return Vec3(ground + s * n); };
  add_line(sketch, on_axis(Real(-3.6)), on_axis(Real(3.6)), {Role::Axis, 1.5f, false, true}, "");
  sketch.labels.push_back({on_axis(Real(3.6)), "n", Role::Axis});
  const Shadow of_a = shadow_of(a, n), of_b = shadow_of(b, n);
  add_line(sketch, on_axis(of_a.low), on_axis(of_a.high), {Role::BodyA, 6});
  add_line(sketch, on_axis(of_b.low), on_axis(of_b.high), {Role::BodyB, 6});
  add_line(sketch, on_axis(of_a.high), on_axis(of_b.low), {Role::Got, 3}, "s(n)");
  const auto drop = [&](const std::vector<Vec3>& corners, Real s, Role role) {
    for (const Vec3& corner : corners) {
      if (std::abs(corner.dot(n) - s) < Real(1e-5))
        add_line(sketch, corner, on_axis(s), {role, 1, true});
    }
  };
  drop(a, of_a.high, Role::BodyA);
  drop(b, of_b.low, Role::BodyB);
  return page_of(sketch, drawing::view_from_above(), {620, 360});
}

/// The hull of a few random points, flattened.
ShapePtr sliver(std::uint32_t seed) {
  std::vector<Vec3> points = random_sphere_points(5, seed);
  for (Vec3& point : points) point.z() *= Real(0.06);
  return shape_of(convex_hull(points).soup);
}

/// How much of an axis a body's shadow covers (m).
Real length_along(const PosedShape& body, const Vec3& axis) {
  std::vector<Vec3> corners(body.mesh().vertices.size());
  for (Index i = 0; i < body.mesh().vertex_count(); ++i) corners[i] = body.vertex(i);
  const Shadow shadow = shadow_of(corners, axis);
  return shadow.high - shadow.low;
}

/// Two slivers in random places, until the axis of their edges points against the line of centroids.
Page centroid() {
  Sequence random(5);
  for (std::uint32_t i = 1; i < 20000; ++i) {
    const ShapePtr shape_a = sliver(2 * i), shape_b = sliver(2 * i + 1);
    const Quat turn_a = random.orientation(), turn_b = random.orientation();
    const Vec3 place = static_cast<Real>(0.7 * random.next()) * random.direction();
    const PosedShape a{shape_a.get(), {Vec3::Zero(), turn_a}};
    const PosedShape b{shape_b.get(), {place, turn_b}};
    SeparatingAxis axis = find_separating_axis(a, b, {}, HUGE_VALF);
    if (axis.feature != AxisFeature::Edges || axis.separation > 0) continue;
    if (axis.axis.dot(place) > Real(-0.06) || place.norm() < Real(0.4)) continue;
    const Vec3 across = (place - place.dot(axis.axis) * axis.axis).normalized();
    if (length_along(a, across) < 1 || length_along(b, across) < 1) continue;
    Drawing sketch = drawing::draw_axis(a, b, axis);
    sketch.title.clear();
    sketch.notes.clear();
    View view;
    view.toward_eye = axis.axis.cross(place).normalized() + Real(0.25) * axis.axis;
    view.up = axis.axis;
    // In front of the bodies, in which it would be hidden.
    drawing::add_arrow(sketch, 4 * view.toward_eye, place, {Role::Got, 3});
    sketch.legend = {{"centroid to centroid", {Role::Got, 3}}};
    return page_of(sketch, view, {620, 380});
  }
  return {};
}

}  // namespace

std::vector<Figure> axis_figures() { return {{"shadows", shadows}, {"centroid", centroid}}; }

}  // namespace cs550::book
