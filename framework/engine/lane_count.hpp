#pragma once
/// @file lane_count.hpp
/// How many constraints or bodies are worked on at a time where the engine does so.

#include <cstddef>

namespace cs550 {

inline constexpr std::size_t lane_count = 8;

}  // namespace cs550
