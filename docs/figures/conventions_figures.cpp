#include "figure.hpp"
#include "sketch.hpp"

namespace cs550::book {
namespace {

Page contact_and_signs() {
  Drawing sketch;
  const Vec3 center_a = at(-2.2, -0.2), center_b = at(2.1, 0.3);
  const Vec3 point_a = at(-0.35, 0.1), point_b = at(0.35, 0.1);
  add_area(sketch, {at(-3.6, -1.3), at(-0.35, -1.2), at(-0.35, 1.1), at(-2.7, 1.4)}, Role::BodyA,
           0.35);
  add_area(sketch, {point_b, at(1.6, -1.2), at(3.5, -0.5), at(3.1, 1.5), at(1.3, 1.4)}, Role::BodyB,
           0.35);
  add_dot(sketch, center_a, Role::BodyA, "A");
  add_dot(sketch, center_b, Role::BodyB, "B");
  const Vec3 middle = Real(0.5) * (point_a + point_b);
  add_line(sketch, center_a, middle, {Role::BodyA, 2, false, true}, "r_A");
  add_line(sketch, center_b, middle, {Role::BodyB, 2, false, true}, "r_B");
  add_line(sketch, at(-0.35, -1.55), at(0.95, -1.55), {Role::Got, 3, false, true},
           "n, from A to B");
  add_line(sketch, at(-0.35, -1.2), at(-0.35, 1.9), {Role::Axis, 1, true});
  add_line(sketch, point_b, at(0.35, 1.9), {Role::Axis, 1, true});
  add_line(sketch, at(-0.35, 1.75), at(0.35, 1.75), {Role::Text, 1.5f}, "d > 0");
  return page_of(sketch, drawing::view_from_above(), {660, 360});
}

}  // namespace

std::vector<Figure> conventions_figures() { return {{"conventions", contact_and_signs}}; }

}  // namespace cs550::book
