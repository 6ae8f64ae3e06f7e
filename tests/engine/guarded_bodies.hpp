#pragma once
/// @file guarded_bodies.hpp
/// Solver bodies of which some must not be written.

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>

#include "cs550/solver_body.hpp"

namespace cs550::test {

/// A copy of bodies whose immovable ones, the last, are in memory that ends the program if it is written.
class GuardedBodies {
 public:
  explicit GuardedBodies(std::span<const SolverBody> bodies) {
    const auto immovable = std::find_if(bodies.begin(), bodies.end(), [](const SolverBody& body) {
      return body.inverse_mass == 0;
    });
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const auto rounded = [&](std::size_t count) {
      return (count * sizeof(SolverBody) + page) / page * page;
    };
    const auto movable = static_cast<std::size_t>(immovable - bodies.begin());
    const std::size_t guarded = rounded(bodies.size() - movable);
    size_ = rounded(movable) + guarded;
    memory_ = mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory_ == MAP_FAILED) throw std::runtime_error("mmap() failed");
    std::byte* const guard = static_cast<std::byte*>(memory_) + rounded(movable);
    auto* const first = reinterpret_cast<SolverBody*>(guard) - movable;
    std::uninitialized_copy(bodies.begin(), bodies.end(), first);
    bodies_ = {first, bodies.size()};
    if (mprotect(guard, guarded, PROT_READ) != 0) throw std::runtime_error("mprotect() failed");
  }
  ~GuardedBodies() { munmap(memory_, size_); }
  GuardedBodies(const GuardedBodies&) = delete;
  GuardedBodies& operator=(const GuardedBodies&) = delete;

  std::span<SolverBody> bodies() const { return bodies_; }

 private:
  void* memory_ = nullptr;
  std::size_t size_ = 0;
  std::span<SolverBody> bodies_;
};

}  // namespace cs550::test
