#include <algorithm>

#include "benchmarks/runs/runs.hpp"
#include "cs550/world.hpp"
#include "engine/counted_allocations.hpp"

namespace cs550::bench {
namespace {

using test::allocated_bytes;
using test::allocation_count;

struct Settled {
  double bytes = 0;
  double bodies = 0;
  double contacts = 0;
  long allocations_per_step = 0;  ///< the most of the last steps whose pairs stayed the same
};

/// The heap of a world after two seconds, without that of its shapes, which the scene owns.
Settled settle(const BenchScene& scene) {
  constexpr int steps = 120, watched = 20;
  const long before = allocated_bytes();
  World world;
  for (const BodyDef& body : scene.bodies) world.add_body(body);
  for (int i = 0; i < steps; ++i) world.step(step_length);
  Settled settled;
  for (int i = 0; i < watched; ++i) {
    const int pairs = world.stats().pairs;
    const long count = allocation_count();
    world.step(step_length);
    if (world.stats().pairs != pairs) continue;
    settled.allocations_per_step =
        std::max(settled.allocations_per_step, allocation_count() - count);
  }
  settled.bytes = static_cast<double>(allocated_bytes() - before);
  settled.bodies = world.body_count();
  settled.contacts = world.stats().contacts;
  return settled;
}

}  // namespace

Memory measure_memory() {
  const NamedScene& stacks = compared_scenes()[1];
  const Settled alone = settle(lone_cubes(16));
  const Settled stacked = settle(stacks.make());
  Memory memory;
  memory.bytes_per_body = alone.bytes / alone.bodies;
  memory.bytes_per_contact =
      (stacked.bytes - stacked.bodies * memory.bytes_per_body) / stacked.contacts;
  memory.allocations_per_step = std::max(alone.allocations_per_step, stacked.allocations_per_step);
  return memory;
}

}  // namespace cs550::bench
