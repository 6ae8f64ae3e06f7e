#pragma once
/// @file diagnostics.hpp
/// Energy and momentum of a world, summed in double precision.

#include "cs550/world.hpp"

namespace cs550 {

/// Mechanical energy of the dynamic bodies (J).
struct Energy {
  double kinetic = 0;    ///< ½·m·v² + ½·ω·L
  double potential = 0;  ///< −m·g·x, zero at the world's origin
  /// KE + PE − ½·h·m·g·v_up, which the semi-implicit step of length h conserves in free fall: each step
  /// loses ½·m·g²·h² of KE + PE, and v_up falls by g·h.
  double invariant = 0;

  /// KE + PE.
  double total() const { return kinetic + potential; }
};

/// The mechanical energy of a world. @param h substep (s), needed for the invariant
Energy energy(const World& world, Real h);

/// Σ P of the dynamic bodies, world frame (kg·m/s).
Eigen::Vector3d linear_momentum(const World& world);

/// Σ L + x × P of the dynamic bodies about the world's origin (kg·m²/s).
Eigen::Vector3d angular_momentum(const World& world);

}  // namespace cs550
