#pragma once
/// @file body_order.hpp
/// The painter's algorithm for convex bodies: those farther away first. Faces need no order within a
/// convex body, since those that face the eye do not hide each other.

#include <cstddef>
#include <vector>

#include "pages/base/camera.hpp"
#include "pages/base/solid.hpp"

namespace cs550::live {

/// The indices of solids from back to front. Two bodies whose pictures overlap are ordered by a plane
/// of a face between them. Where no face separates them, the one whose centre is nearer is in front; a
/// cycle is broken there too. O(n²) where everything overlaps; typically O(n log n).
/// @pre each solid has a mesh
std::vector<std::size_t> back_to_front(const std::vector<pages::Solid>& solids,
                                       const pages::Projection& seen);

}  // namespace cs550::live
