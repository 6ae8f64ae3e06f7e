#pragma once
/// @file displacement.hpp
/// How far the surface of a body has moved between two poses.

#include <algorithm>

#include "cs550/math.hpp"

namespace cs550 {

/// An upper bound on the distance that any point within `radius` of a body's origin has moved (m).
inline Real largest_displacement(const Pose& before, const Pose& now, Real radius) {
  // Unit quaternions that are an angle θ apart differ by 2 sin(θ/4), with the nearer of their two signs. A
  // point at distance r moves by 2r·sin(θ/2) ≤ 4r·sin(θ/4).
  const auto p = before.orientation.coeffs();
  const auto q = now.orientation.coeffs();
  const Real turn = std::sqrt(std::min((q - p).squaredNorm(), (q + p).squaredNorm()));
  return (now.position - before.position).norm() + 2 * radius * turn;
}

}  // namespace cs550
