#pragma once
/// @file pictures.hpp
/// Pictures of failed tests of lab 7.

#include <string>
#include <vector>

#include "cs550/world.hpp"
#include "drawing/impulse_drawing.hpp"
#include "drawing/mesh_drawing.hpp"
#include "drawing/text.hpp"
#include "helpers/picture.hpp"

namespace cs550::test {

/// The friction disk with the expected and the actual impulse.
/// @param limit μ·λ_n (N·s)
/// @param slip along u and v, before friction (m/s)
inline std::string friction_picture(Real limit, const Vec3& expected, const Vec2& got,
                                    const Vec3& slip) {
  const drawing::DiskImpulse impulses[] = {
      {expected.head<2>(), drawing::Role::Expected, "expected"}, {got, drawing::Role::Got, "got"}};
  const drawing::Drawing disk = drawing::draw_friction_disk(limit, impulses, slip.head<2>());
  return side_by_side("Friction impulse along u and v",
                      {drawing::Scene{disk, drawing::view_from_above()}});
}

/// The bodies of a world that are not static.
inline drawing::Drawing movable_bodies(const World& world, drawing::Role role) {
  drawing::MeshStyle style;
  style.role = role;
  style.opacity = Real(0.9);
  drawing::Drawing drawing;
  for (Index i = 0; i < static_cast<Index>(world.bodies().size()); ++i) {
    const BodyId body = world.id_at(i);
    if (!world.is_alive(body) || world.body(body).kind == BodyKind::Static) continue;
    append(drawing, drawing::draw_body(world.posed_shape(body), style));
  }
  return drawing;
}

/// The largest displacement of any body, in words.
inline std::string farthest_move(const World& start, const World& now) {
  Real farthest = 0;
  for (std::size_t i = 0; i < start.bodies().size(); ++i) {
    const Vec3 moved = now.bodies()[i].pose.position - start.bodies()[i].pose.position;
    if (moved.norm() > farthest) farthest = moved.norm();
  }
  return "The body that moved most moved by " +
         drawing::length_text(static_cast<double>(farthest)) + ".";
}

/// The initial poses of bodies at rest beside their present poses.
inline std::string standing_picture(const World& start, const World& now) {
  drawing::Drawing expected = movable_bodies(start, drawing::Role::Expected);
  expected.title = "as at the start";
  expected.alt_text = "The bodies at the start.";
  drawing::Drawing got = movable_bodies(now, drawing::Role::Got);
  got.title = "after " + std::to_string(std::lround(now.time())) + " s";
  got.alt_text = "The bodies in the end.";
  drawing::View view;
  view.toward_eye = {Real(0.8), -3, Real(0.5)};
  return expected_beside_got("Bodies that should stand still", expected, got, view,
                             farthest_move(start, now));
}

}  // namespace cs550::test
