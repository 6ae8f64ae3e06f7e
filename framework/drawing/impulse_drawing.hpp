#pragma once
/// @file impulse_drawing.hpp
/// **Labs 6 and 7:** Impulses at contacts, their convergence, and the friction disk.

#include "cs550/contact_constraint.hpp"
#include "drawing/drawing.hpp"
#include "drawing/plot.hpp"

namespace cs550::drawing {

/// The constraints of a contact solver. Each has a dot, its normal, and the accumulated normal and
/// friction impulses on B as arrows.
/// @param centers of mass, world frame (m), one for each body. Constraints with another body_b are
/// left out, with a note
/// @param meters_per_impulse length of an arrow for 1 N·s
Drawing draw_impulses(std::span<const ContactConstraint> constraints, std::span<const Vec3> centers,
                      Real meters_per_impulse, Role role = Role::Highlight);

/// The scale at which the largest impulse has a given length (m per N·s).
/// @param length of the longest arrow (m)
Real impulse_scale(std::span<const ContactConstraint> constraints, Real length);

/// A friction impulse in the plane of u and v.
struct DiskImpulse {
  Vec2 impulse = Vec2::Zero();  ///< λ_u, λ_v (N·s)
  Role role = Role::Got;        ///< its meaning
  std::string name;             ///< for the legend
};

/// The disk ‖λ‖ ≤ μ·λ_n in the plane of u and v, with impulses as arrows from its centre, and the
/// square to which separate bounds for u and v would limit them. To be viewed from above.
/// @param limit μ·λ_n (N·s)
/// @param slip J_u v and J_v v before friction (m/s): friction opposes it
Drawing draw_friction_disk(Real limit, std::span<const DiskImpulse> impulses, const Vec2& slip);

/// The impulses of some constraints after each pass.
/// @param history one entry for each pass, with one impulse for each constraint (N·s)
Plot plot_impulses(std::span<const std::vector<Real>> history);

/// A quantity that should converge to zero over the passes of a solver.
struct Convergence {
  std::string name;          ///< for the legend
  std::vector<Real> errors;  ///< after each pass, ≥ 0
  bool dashed = false;       ///< so that colour is not the only difference
};

/// Plots errors on a logarithmic scale over the passes. @param y_label with its unit
Plot plot_convergence(std::span<const Convergence> runs, const std::string& y_label);

}  // namespace cs550::drawing
