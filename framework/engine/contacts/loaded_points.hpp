#pragma once
/// @file loaded_points.hpp
/// Contact points that a new manifold leaves out although they still carry load.

#include "cs550/contact.hpp"

namespace cs550 {

/// A manifold has four points of one face of each body. Of three or more corners that touch, another
/// face or another choice of four can leave out one that carries load. The body would fall on it for a
/// step or two until it is chosen again, and so never come to rest.
///
/// Adds the points of the last manifold that carry load, have no counterpart in the new one and are
/// still inside the other body. If the new manifold is full, such a point takes the place of the one
/// with the widest gap; that one carries nothing yet.
/// @param a, b the bodies at their present poses
/// @param before manifold of the last step, with its impulses
/// @param reach a gap up to it may close before the next manifold, so its point stays (m)
/// @param now manifold of this step
void keep_loaded_points(const PosedShape& a, const PosedShape& b, const Manifold& before,
                        Real reach, Manifold& now);

}  // namespace cs550
