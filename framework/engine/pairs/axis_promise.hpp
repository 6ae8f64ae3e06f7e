#pragma once
/// @file axis_promise.hpp
/// What the engine relies on in an answer of lab 4.

#include "cs550/separating_axis.hpp"

namespace cs550 {

/// The rounding of a normalised vector or quaternion, with a margin for one product of such.
inline constexpr Real unit_tolerance = Real(1e-3);

bool is_unit(const Vec3& v);

/// The promise that lab 4 broke for this axis, or nullptr: a finite separation along a unit vector, and features that exist.
/// @param a, b meshes of the bodies
const char* broken_promise(const SeparatingAxis& axis, const HalfEdgeMesh& a,
                           const HalfEdgeMesh& b);

}  // namespace cs550
