#pragma once
/// @file trajectory_drawing.hpp
/// **Lab 1:** The path, orientation and energy of a body.

#include "cs550/math.hpp"
#include "drawing/drawing.hpp"
#include "drawing/plot.hpp"

namespace cs550::drawing {

/// The path of a point that is fixed to the body.
/// @param poses in the order of time
/// @param body_point body frame (m): zero follows the centre of mass
Drawing draw_trail(std::span<const Pose> poses, const Vec3& body_point, const Stroke& stroke,
                   const std::string& name);

/// A box at a pose, as its edges and translucent faces. @param half_extents (m)
Drawing draw_box(const Pose& pose, const Vec3& half_extents, Role role, Real opacity = Real(0.4));

/// The angular velocity in the body frame on the ellipsoid ω·Iω = 2T of the energy at the start
/// (Poinsot). A method that conserves energy stays on it, on one closed curve, the polhode.
/// @param inertia body frame, diagonal, positive (kg·m²)
/// @param angular_velocities body frame, in the order of time (rad/s)
Drawing draw_polhode(const Vec3& inertia, std::span<const Vec3> angular_velocities,
                     const Stroke& stroke, const std::string& name);

/// The ellipsoid of an energy in the space of the body's angular velocities. @param energy T (J)
Drawing draw_energy_ellipsoid(const Vec3& inertia, Real energy);

/// A quantity over a run.
struct Recorded {
  std::string name;          ///< for the legend
  std::vector<Real> values;  ///< one per step
  Role role = Role::Got;     ///< its meaning
  bool dashed = false;       ///< so that colour is not the only difference
};

/// Values over time. @param h time between two values (s)
Plot plot_over_time(const std::string& title, const std::string& y_label, Real h,
                    std::span<const Recorded> recorded);

}  // namespace cs550::drawing
