#include "cs550/integration.hpp"
#include "figure.hpp"
#include "free_box.hpp"
#include "sketch.hpp"

namespace cs550::book {
namespace {

Page lever() {
  Drawing sketch;
  const Vec3 center = at(0, 0), point = at(1.5, 0.75);
  add_area(sketch, {at(-2, -0.75), at(2, -0.75), at(2, 0.75), at(-2, 0.75)}, Role::BodyA, 0.35);
  add_dot(sketch, center, Role::BodyA, "x");
  add_dot(sketch, point, Role::Got, "p");
  add_line(sketch, center, point, {Role::Axis, 2, false, true}, "p − x");
  add_line(sketch, point, at(0.9, 2.1), {Role::Got, 3, false, true}, "F");
  std::vector<Vec3> turn;
  for (int i = 0; i <= 6; ++i) {
    const double angle = -0.6 + 2.4 * i / 6;
    turn.push_back(at(0.55 * std::cos(angle), 0.55 * std::sin(angle)));
  }
  drawing::add_curve(sketch, turn, {Role::Expected, 2.5f, false, true});
  sketch.labels.push_back({at(-0.35, 0.5), "τ = (p − x) × F", Role::Expected});
  return page_of(sketch, drawing::view_from_above(), {560, 320});
}

/// The angular momentum in the body's frame, of unit length, step by step.
std::vector<Vec3> polhode(RotationMethod method, double seconds) {
  RigidBody body = free_box(Vec3(Real(0.5), 5, Real(0.5)));
  std::vector<Vec3> points;
  for (int i = 0; i < static_cast<int>(60 * seconds); ++i) {
    points.push_back(Real(1.004) * body.pose.unrotate(body.angular_momentum).normalized());
    turn(body, frame, method);
  }
  return points;
}

Page polhodes() {
  Drawing sketch;
  sketch.balls.push_back({Vec3::Zero(), 1, Role::Faint, Real(0.45)});
  drawing::add_curve(sketch, polhode(RotationMethod::Explicit, 12), {Role::Got, 1.4f});
  drawing::add_curve(sketch, polhode(RotationMethod::ImplicitMidpoint, 12), {Role::BodyA, 3});
  const char* names[] = {"x", "y", "z: least inertia"};
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = Vec3::Unit(i);
    drawing::add_arrow(sketch, axis, Real(0.35) * axis, {Role::Axis, 1.5f}, names[i]);
  }
  sketch.legend = {{"implicit midpoint", {Role::BodyA, 3}}, {"explicit", {Role::Got, 2}}};
  View view;
  view.toward_eye = Vec3(1, Real(1.6), Real(0.8));
  return page_of(sketch, view, {560, 440});
}

}  // namespace

std::vector<Figure> rigid_body_figures() { return {{"lever", lever}, {"polhodes", polhodes}}; }

}  // namespace cs550::book
