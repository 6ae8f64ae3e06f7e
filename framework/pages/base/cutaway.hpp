#pragma once
/// @file cutaway.hpp
/// Seeing into boxes.

#include <vector>

#include "pages/base/solid.hpp"

namespace cs550::pages {

/// How far along a ray a convex mesh is entered (m); HUGE_VALF for a miss.
/// @param origin, direction in the mesh's frame
Real entry_distance(const HalfEdgeMesh& mesh, const Vec3& origin, const Vec3& direction);

/// Makes ground that hides more than a few of the other solids translucent: the near wall of a pit.
/// @param eye world (m)
void open_view(std::vector<Solid>& solids, const Vec3& eye);

}  // namespace cs550::pages
