#pragma once
/// @file scene_limits.hpp
/// Refuses bodies that float cannot hold.

#include <string>
#include <vector>

#include "cs550/scene.hpp"

namespace cs550 {

/// Throws SceneFault for a dynamic body thinner than a needle of about 1 : 1400, and for dynamic
/// bodies whose masses differ by a factor of more than 1e9. Beyond these the sums of a contact's
/// effective mass lose digits that its impulses need. Throws also for a dynamic body whose mass, inertia,
/// momentum or energy would overflow in the first step.
/// @param paths of the bodies in the file; that of its generator for a generated one
void refuse_beyond_float(const Scene& scene, const std::vector<std::string>& paths);

}  // namespace cs550
