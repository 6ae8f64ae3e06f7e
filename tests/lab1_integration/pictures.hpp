#pragma once
/// @file pictures.hpp
/// Pictures of failed motions. The motion is repeated only after a failure.

#include <string>
#include <vector>

#include "drawing/trajectory_drawing.hpp"
#include "helpers/picture.hpp"
#include "helpers/story.hpp"
#include "lab1_integration/free_body.hpp"

namespace cs550::test {

/// A freely rotating body beside the true rotation: the path of the tip of its longest half-axis,
/// and its energy.
inline std::string tumbling_picture(const RigidBody& start, double seconds, int rate,
                                    RotationMethod method) {
  using drawing::Role;
  const Real h = Real(1) / static_cast<Real>(rate);
  RigidBody body = start;
  FreeRotation exact(start);
  std::vector<Pose> poses, exact_poses;
  drawing::Recorded energy{"got", {}, Role::Got, false};
  drawing::Recorded exact_energy{"expected", {}, Role::Expected, true};
  for (int i = 0; i <= static_cast<int>(seconds * rate); ++i) {
    poses.push_back(body.pose);
    exact_poses.push_back({start.pose.position, exact.orientation().cast<Real>()});
    energy.values.push_back(static_cast<Real>(rotational_energy(body) / rotational_energy(start)));
    exact_energy.values.push_back(1);
    turn(body, h, method);
    exact.advance(double{h});
  }
  const Vec3 tip(0, 0, 1);
  const Vec3 half(Real(0.2), Real(0.5), 1);
  const auto motion = [&](const std::vector<Pose>& way, Role role, const std::string& name) {
    drawing::Drawing picture = drawing::draw_trail(way, tip, {role, 2, false, false}, name);
    append(picture, drawing::draw_box(way.back(), half, role));
    picture.legend.clear();
    drawing::View view;
    view.frame = {Vec3::Constant(Real(-0.9)), Vec3::Constant(Real(0.9))};
    return drawing::Scene{picture, view};
  };
  const drawing::Recorded curves[] = {exact_energy, energy};
  return side_by_side("The way of the tip of the long axis, and the energy",
                      {motion(exact_poses, Role::Expected, "Expected: the true rotation"),
                       motion(poses, Role::Got, "Got: your rotation"),
                       drawing::plot_over_time("Energy", "energy / initial energy", h, curves)},
                      "Drawn in sizes of the body. Without forces the energy stays what it is.");
}

/// A force or an impulse at a point.
struct Push {
  Vec3 vector;
  Vec3 point;  ///< world frame (m)
};

/// Pushes and their levers, with the turning effect expected beside the one found.
/// @param reach how far from the centre of mass the points are (m)
/// @param effect "torque" or "change of L"
inline std::string lever_picture(const Pose& pose, const Vec3& half_extents,
                                 const std::vector<Push>& pushes, Real reach,
                                 const std::string& effect, const Vec3& expected, const Vec3& got) {
  using drawing::Role;
  Real strongest = 0;
  for (const Push& push : pushes) strongest = std::max(strongest, push.vector.norm());
  const Real largest = std::max(expected.norm(), got.norm());
  const auto drawn = [&](const Vec3& turn, Role role) {
    drawing::Drawing drawing =
        drawing::draw_box({Vec3::Zero(), pose.orientation}, half_extents, Role::Faint, Real(0.3));
    drawing.points.push_back({Vec3::Zero(), Role::Text, 5});
    for (const Push& push : pushes) {
      const Vec3 lever = push.point - pose.position;
      drawing.lines.push_back({Vec3::Zero(), lever, {Role::Axis, 2, true, false}});
      add_arrow(drawing, lever, Real(0.7) * reach / strongest * push.vector,
                {Role::BodyA, 3, false, true});
    }
    if (largest > 0) add_arrow(drawing, Vec3::Zero(), reach / largest * turn, {role, 3}, effect);
    const bool is_expected = role == Role::Expected;
    drawing.title = (is_expected ? "Expected: " : "Got: ") + effect + ' ' + Story::show(turn);
    drawing.alt_text = "A box with its levers, pushes and the " + effect + '.';
    drawing.legend = {{"lever from the centre of mass", {Role::Axis, 2, true, false}},
                      {"push", {Role::BodyA, 3, false, true}},
                      {effect, {role, 3, false, true}}};
    drawing::View view;
    view.frame = {Vec3::Constant(Real(-0.85) * reach), Vec3::Constant(Real(0.85) * reach)};
    return drawing::Scene{drawing, view};
  };
  return side_by_side("A push off the centre of mass turns the body",
                      {drawn(expected, Role::Expected), drawn(got, Role::Got)},
                      "The turn is about lever × push, by the right-hand rule.");
}

/// A fall beside the closed form x₀ + v₀·t + ½·g·t² − ½·g·h·t.
/// @param got positions after each step, m
inline std::string fall_picture(const std::vector<Vec3>& got, const Vec3& v0, const Vec3& g,
                                Real h) {
  using drawing::Role;
  std::vector<Pose> fall, exact;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const Real t = static_cast<Real>(i) * h;
    fall.push_back({got[i], Quat::Identity()});
    exact.push_back({t * v0 + Real(0.5) * t * (t + h) * g, Quat::Identity()});
  }
  const auto way = [](const std::vector<Pose>& poses, Role role, const std::string& name) {
    drawing::Drawing drawing =
        drawing::draw_trail(poses, Vec3::Zero(), {role, Real(2.4), false, true}, name);
    drawing.legend.clear();
    return drawing;
  };
  drawing::Drawing both = way(exact, Role::Faint, "");
  append(both, way(fall, Role::Got, ""));
  both.title = "your path";
  both.alt_text = "The path of the centre of mass, with the closed form behind it.";
  return expected_beside_got("The path of the centre of mass, seen from the front",
                             way(exact, Role::Expected, "the closed form"), both,
                             drawing::view_from_front());
}

}  // namespace cs550::test
