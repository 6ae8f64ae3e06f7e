#pragma once
/// @file scene_limits.hpp
/// Refuses scenes that would fill the memory or take minutes to load.

#include <cstdint>
#include <string>

#include "cs550/scene.hpp"

namespace cs550 {

/// The sentence about a count that exceeds its limit. @param variable that raises the limit
std::string beyond_limit(std::int64_t found, int limit, const std::string& things,
                         const std::string& variable);

/// Throws SceneFault if more pairs of bodies overlap by their bounds than the limit allows: each costs
/// memory and time in every step. Counts no further than the body that exceeds the limit.
void refuse_many_pairs(const Scene& scene, const SceneLimits& limits);

}  // namespace cs550
