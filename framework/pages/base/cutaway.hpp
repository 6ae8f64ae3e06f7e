#pragma once
/// @file cutaway.hpp
/// Makes walls translucent that hide the scene.

#include <vector>

#include "pages/base/solid.hpp"

namespace cs550::pages {

/// The distance along a ray to its entry into a convex mesh (m), or HUGE_VALF for a miss.
/// @param origin, direction in the mesh's frame
Real entry_distance(const HalfEdgeMesh& mesh, const Vec3& origin, const Vec3& direction);

/// Makes ground translucent if it hides many other solids, such as the near wall of a pit.
/// @param eye world frame (m)
void open_view(std::vector<Solid>& solids, const Vec3& eye);

}  // namespace cs550::pages
