#pragma once
/// @file four_threads.hpp
/// A world uses at most as many threads as the machine runs at once. These tests need four on any machine.

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <stdexcept>

#include "engine/threads/thread_team.hpp"

namespace cs550::test {

/// Calls `work` where a world can use four threads, even if they have to share processors.
template <class Work>
void with_four_threads(const Work& work) {
  constexpr int count = 4;
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, count);
  tbb::task_arena arena(count);
  arena.execute([&] {
    if (useful_threads(count) != count) throw std::runtime_error("four threads cannot be used");
    work();
  });
}

}  // namespace cs550::test
