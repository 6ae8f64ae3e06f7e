#pragma once
/// @file loaded_points.hpp
/// Contact points that a new manifold omits although they carry load.

#include "cs550/contact.hpp"

namespace cs550 {

/// A manifold holds at most four points, all on one face of each body. If more corners touch, the next
/// manifold may omit one that carries load, because another face or another four points were chosen.
/// The body then falls onto that corner until it is chosen again, and some bodies never come to rest.
///
/// Adds those points of the last manifold that carry load, are missing from the new one and are still
/// inside the body that owns the reference face. If the new manifold is full, such a point replaces
/// the one with the widest gap. On the incident body it stays where it is. Nothing changes if the two
/// manifolds do not have their reference faces on the same body.
///
/// Called before carry_impulses().
/// @param a, b the bodies at their present poses
/// @param before manifold of the last step, with its impulses
/// @param reach points across a gap up to this width are not replaced (m)
/// @param now manifold of this step
void keep_loaded_points(const PosedShape& a, const PosedShape& b, const Manifold& before,
                        Real reach, Manifold& now);

}  // namespace cs550
