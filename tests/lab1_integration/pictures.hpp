#pragma once
/// @file pictures.hpp
/// Pictures of failed motions. The motion is repeated only after a failure.

#include <string>
#include <vector>

#include "drawing/trajectory_drawing.hpp"
#include "helpers/picture.hpp"
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
