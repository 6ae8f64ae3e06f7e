#include "cs550/constraint_solver.hpp"
#include "cs550/world.hpp"
#include "drawing/mesh_drawing.hpp"
#include "figure.hpp"
#include "sketch.hpp"
#include "stack.hpp"

namespace cs550::book {
namespace {

/// Two bodies that touch in one point, with their centres.
Drawing two_bodies() {
  Drawing sketch;
  add_area(sketch, {at(-3, -1), at(0, -0.9), at(0, 1), at(-2.6, 1.1)}, Role::BodyA, 0.35);
  add_area(sketch, {at(0, 0.2), at(1.2, -1.1), at(3, -0.3), at(2.4, 1.3), at(0.9, 1.3)},
           Role::BodyB, 0.35);
  add_dot(sketch, at(-1.7, -0.1), Role::BodyA, "A");
  add_dot(sketch, at(1.6, 0.75), Role::BodyB, "B");
  return sketch;
}

Page blow() {
  Drawing sketch = two_bodies();
  const Vec3 contact = at(0, 0.2);
  add_line(sketch, at(-1.7, -0.1), contact, {Role::BodyA, 1.5f, true});
  add_line(sketch, at(1.6, 0.75), contact, {Role::BodyB, 1.5f, true});
  add_line(sketch, contact, at(-1.2, 0.2), {Role::BodyA, 3.5f, false, true});
  add_line(sketch, contact, at(1.2, 0.2), {Role::BodyB, 3.5f, false, true});
  add_line(sketch, at(-0.4, -1.35), at(0.5, -1.35), {Role::Axis, 2.5f, false, true}, "n");
  add_dot(sketch, contact, Role::Got, "", 5);
  sketch.labels.insert(sketch.labels.end(), {{at(-0.9, -0.3), "r_A", Role::BodyA},
                                             {at(0.75, 0.68), "r_B", Role::BodyB},
                                             {at(-0.9, 0.45), "−j n", Role::BodyA},
                                             {at(0.9, -0.1), "+j n", Role::BodyB}});
  return page_of(sketch, drawing::view_from_above(), {620, 300});
}

Page jacobian() {
  Drawing sketch = two_bodies();
  const Vec3 contact = at(0, 0.2);
  const auto turning = [&](const Vec3& middle, double from, double to, Role role,
                           const std::string& text) {
    std::vector<Vec3> arc;
    for (int i = 0; i <= 6; ++i) {
      const double angle = from + (to - from) * i / 6;
      arc.push_back(middle + at(0.5 * std::cos(angle), 0.5 * std::sin(angle)));
    }
    drawing::add_curve(sketch, arc, {role, 2.5f, false, true});
    sketch.labels.push_back({arc[3], text, role});
  };
  add_line(sketch, at(-1.7, -0.1), at(-2.6, -0.1), {Role::BodyA, 3, false, true}, "−n");
  add_line(sketch, at(1.6, 0.75), at(2.5, 0.75), {Role::BodyB, 3, false, true}, "n");
  turning(at(-1.7, -0.1), 0.4, 2.6, Role::BodyA, "−r_A × n");
  turning(at(1.6, 0.75), -0.5, -2.7, Role::BodyB, "r_B × n");
  add_line(sketch, at(-1.7, -0.1), contact, {Role::BodyA, 1, true});
  add_line(sketch, at(1.6, 0.75), contact, {Role::BodyB, 1, true});
  add_dot(sketch, contact, Role::Got, "contact", 5);
  return page_of(sketch, drawing::view_from_above(), {620, 300});
}

/// The boxes of a world on a part of its floor.
Drawing boxes_of(const World& world) {
  Drawing sketch;
  for (Index i = 0; i < static_cast<Index>(world.bodies().size()); ++i) {
    if (world.bodies()[i].kind == BodyKind::Static) continue;
    drawing::append(sketch, drawing::draw_body(world.posed_shape(world.id_at(i)),
                                               {i % 2 == 0 ? Role::BodyA : Role::Reference, 1}));
  }
  sketch.polygons.push_back(
      {{Vec3(-4, -4, 0), Vec3(4, -4, 0), Vec3(4, 4, 0), Vec3(-4, 4, 0)}, Role::Faint, Real(0.5)});
  return sketch;
}

Page naive_stack_picture() {
  World naive = stack_of_boxes(10, SolverKind::Naive, 4);
  World constraint = stack_of_boxes(10, SolverKind::Constraint);
  for (int i = 0; i < 120; ++i) {
    naive.step(Real(1) / 60);
    constraint.step(Real(1) / 60);
  }
  Drawing left = boxes_of(naive), right = boxes_of(constraint);
  left.title = "naive, four passes";
  right.title = "constraint solver";
  View view = drawing::view_from_front();
  view.toward_eye = Vec3(Real(0.35), -1, Real(0.22));
  view.frame.include(Vec3(-3, -3, 0));
  view.frame.include(Vec3(3, 3, 10));
  Page page = page_of({left, right}, view, {300, 430});
  page.framed_by_first = true;
  return page;
}

/// A slip, and the impulses that could answer it, for a contact that gives way less along one tangent.
Page friction_mass() {
  Mat2 mass;
  mass << Real(0.45), Real(0.38), Real(0.38), Real(1.1);
  const Vec2 slip(Real(1.5), Real(0.5));
  const Real limit = Real(0.55);
  const Vec2 stopping = -(mass * slip);
  const Vec2 against = -limit * slip.normalized();
  const auto point = [](const Vec2& v) { return Vec3(v.x(), v.y(), 0); };
  Drawing sketch;
  add_outline(sketch, regular_polygon(72, at(0, 0), static_cast<double>(limit)),
              {Role::Axis, 1.5f});
  add_line(sketch, at(0, 0), point(slip), {Role::BodyB, 3, false, true}, "slip s");
  add_line(sketch, at(0, 0), point(-slip), {Role::Faint, 1, true});
  add_line(sketch, at(0, 0), point(stopping), {Role::Got, 2, true, true});
  add_line(sketch, at(0, 0), point(limit * stopping.normalized()), {Role::Got, 3, false, true},
           "scaled back");
  add_line(sketch, at(0, 0), point(against), {Role::BodyA, 3.5f, false, true});
  sketch.labels.insert(sketch.labels.end(), {{at(0.5, -0.45), "μ λ_n", Role::Axis},
                                             {at(-0.7, -1.1), "−m_t s", Role::Got},
                                             {at(-0.9, 0.02), "against the slip", Role::BodyA}});
  return page_of(sketch, drawing::view_from_above(), {620, 360});
}

}  // namespace

std::vector<Figure> solver_figures() {
  return {{"blow", blow},
          {"jacobian", jacobian},
          {"naive_stack_picture", naive_stack_picture},
          {"friction_mass", friction_mass}};
}

}  // namespace cs550::book
