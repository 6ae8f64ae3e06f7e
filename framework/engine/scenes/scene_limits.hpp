#pragma once
/// @file scene_limits.hpp
/// Refuses scenes that would fill the memory or take minutes to load, and bodies that float cannot
/// hold.

#include <cstdint>
#include <string>
#include <vector>

#include "cs550/scene.hpp"

namespace cs550 {

/// The sentence about a count that exceeds its limit. @param variable that raises the limit
std::string beyond_limit(std::int64_t found, int limit, const std::string& things,
                         const std::string& variable);

/// Throws SceneFault if more pairs of bodies overlap by their bounds than the limit allows: each costs
/// memory and time in every step. Counts no further than the body that exceeds the limit.
void refuse_many_pairs(const Scene& scene, const SceneLimits& limits);

/// Throws SceneFault for a dynamic body thinner than a needle of about 1 : 1400, and for dynamic
/// bodies whose masses differ by a factor of more than 1e9. Beyond these the sums of a contact's
/// effective mass lose digits that its impulses need. Throws also for a dynamic body whose mass, inertia,
/// momentum or energy would overflow in the first step.
/// @param paths of the bodies in the file; that of its generator for a generated one
void refuse_beyond_float(const Scene& scene, const std::vector<std::string>& paths);

}  // namespace cs550
