#pragma once
/// @file prefetch.hpp
/// Fetches memory into the cache before it is needed.

#include <cstddef>

#include "engine/threads/thread_team.hpp"

namespace cs550 {

inline void prefetch(const void* first, std::size_t size) {
  const char* const bytes = static_cast<const char*>(first);
  for (std::size_t line = 0; line < size; line += cache_line) __builtin_prefetch(bytes + line);
  // To g++ a function that only prefetches has no effect: it would delete the calls.
  asm volatile("");
}

}  // namespace cs550
