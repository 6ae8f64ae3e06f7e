#pragma once
/// @file pictures.hpp
/// Pictures of failed collisions.

#include <algorithm>
#include <string>

#include "drawing/drawing.hpp"
#include "helpers/picture.hpp"
#include "helpers/story.hpp"
#include "lab6_naive_solver/collision.hpp"

namespace cs550::test {

/// Two bodies as centres of mass, lever arms and velocities.
/// @param meters_per_speed length of an arrow for 1 m/s
inline drawing::Drawing draw_collision(const Collision& at, Real meters_per_speed) {
  using drawing::Role;
  drawing::Drawing drawing;
  const Vec3 contact = Vec3::Zero();
  const auto add_body = [&](const SolverBody& body, const Vec3& r, Role role, const char* name) {
    const Vec3 center = contact - r;
    drawing.lines.push_back({center, contact, {role, 2, true, false}});
    drawing.points.push_back({center, role, 7});
    drawing.labels.push_back({center, name, role});
    add_arrow(drawing, center, meters_per_speed * body.v, {role, 3, false, true});
    add_arrow(drawing, contact, meters_per_speed * (body.v + body.w.cross(r)),
              {role, Real(1.8), false, true});
  };
  add_body(at.a, at.constraint.r_a, Role::BodyA, "A");
  add_body(at.b, at.constraint.r_b, Role::BodyB, "B");
  const Real reach = std::max(at.constraint.r_a.norm(), at.constraint.r_b.norm());
  add_arrow(drawing, contact, Real(0.3) * reach * at.constraint.n, {Role::Axis, 2, false, true},
            "n");
  drawing.points.push_back({contact, Role::Highlight, 5});
  drawing.legend = {{"velocity of the centre of mass", {Role::Axis, 3, false, false}},
                    {"of the contact", {Role::Axis, Real(1.8), false, false}}};
  return drawing;
}

/// The length of an arrow for 1 m/s. Arrows from neighbouring points must not cover each other.
inline Real meters_per_speed(const Collision& at) {
  const Vec3 of_a = at.a.v + at.a.w.cross(at.constraint.r_a);
  const Vec3 of_b = at.b.v + at.b.w.cross(at.constraint.r_b);
  const Real centers = std::max(at.a.v.norm(), at.b.v.norm());
  const Real fastest = centers > 0 ? centers : std::max(of_a.norm(), of_b.norm());
  const Real reach = std::max(at.constraint.r_a.norm(), at.constraint.r_b.norm());
  return fastest > 0 && reach > 0 ? Real(0.45) * reach / fastest : Real(1);
}

/// The velocities from which v_n follows.
inline std::string velocity_picture(const Collision& at, double expected, double got) {
  drawing::Drawing given = draw_collision(at, meters_per_speed(at));
  given.title = "Given: two bodies and their contact";
  given.alt_text = "Two bodies with the velocities of their centres and of their contact points.";
  return side_by_side("How fast the contact opens", {drawing::Scene{given, {}}},
                      "The thin arrows at the contact differ by " + Story::show(expected, "m/s") +
                          " along n. Your function returned " + Story::show(got, "m/s") + ".");
}

/// A collision before and after the pass, at the same scale.
inline std::string collision_picture(const Collision& before, const Collision& after) {
  const Real scale = meters_per_speed(before);
  drawing::View view;
  drawing::Drawing start = draw_collision(before, scale);
  start.title = "Given: before the impulse";
  start.alt_text = "Two bodies that meet, with their velocities before the impulse.";
  view.frame = bounds(start);
  drawing::Drawing end = draw_collision(after, scale);
  end.title = "Got: after it";
  end.alt_text = "The same bodies with their velocities after the impulse.";
  return side_by_side("A collision: along n the contact must not approach any more",
                      {drawing::Scene{start, view}, drawing::Scene{end, view}});
}

}  // namespace cs550::test
