// A steady-state step does not allocate.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <new>

#include "cs550/scene.hpp"
#include "engine/counted_allocations.hpp"
#include "engine/four_threads.hpp"
#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

long allocations_of_a_step(World& world) {
  const long before = allocation_count();
  world.step(step_length);
  return allocation_count() - before;
}

TEST(Allocation, TheCounterCounts) {
  const long before = allocation_count();
  const long bytes_before = allocated_bytes();
  void* const something = ::operator new(100);  // an explicit call, which compilers may not remove
  EXPECT_EQ(allocation_count(), before + 1);
  EXPECT_EQ(allocated_bytes(), bytes_before + 100);
  ::operator delete(something);
  EXPECT_EQ(allocated_bytes(), bytes_before);
}

TEST(Allocation, TheCounterCountsAlignedBlocks) {
  const long before = allocation_count();
  const long bytes_before = allocated_bytes();
  constexpr auto cache_line = std::align_val_t(64);
  void* const something = ::operator new(100, cache_line);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(something) % 64, 0U);
  EXPECT_EQ(allocation_count(), before + 1);
  EXPECT_EQ(allocated_bytes(), bytes_before + 100);
  ::operator delete(something, cache_line);
  EXPECT_EQ(allocated_bytes(), bytes_before);
}

/// Runs a heap until the steps with new pairs are few.
void expect_no_allocation_once_warm(const WorldSettings& settings) {
  World world = falling_hulls(30, 31);
  world.settings() = settings;
  long with_constant_pairs = 0;
  int steps_with_constant_pairs = 0;
  int pairs_before = 0;
  for (int step = 0; step < 400; ++step) {
    const long count = allocations_of_a_step(world);
    if (world.stats().pairs == pairs_before && step > 200) {
      with_constant_pairs += count;
      ++steps_with_constant_pairs;
    }
    pairs_before = world.stats().pairs;
  }
  ASSERT_GT(steps_with_constant_pairs, 50);
  ASSERT_GT(world.stats().contacts, 15);
  EXPECT_EQ(with_constant_pairs, 0);
}

TEST(Allocation, NoneInAStepWhileThePairsStayTheSame) { expect_no_allocation_once_warm({}); }

/// Of any number of threads, solver and contact model, and of the checks.
TEST(Allocation, NoneInAStepWithOtherSettings) {
  const auto expect_none = [](const char* name, auto change) {
    SCOPED_TRACE(name);
    WorldSettings settings;
    change(settings);
    expect_no_allocation_once_warm(settings);
  };
  expect_none("game", [](WorldSettings& s) { set_quality(s, Quality::Game); });
  expect_none("Baumgarte", [](WorldSettings& s) { s.contact_model = ContactModel::Baumgarte; });
  expect_none("naive", [](WorldSettings& s) { s.solver = SolverKind::Naive; });
  expect_none("no coherence", [](WorldSettings& s) { s.temporal_coherence = false; });
  expect_none("audit", [](WorldSettings& s) { s.audit_momentum = true; });
  expect_none("checks", [](WorldSettings& s) { s.check_stages = true; });
  with_four_threads([&] {
    expect_none("four threads", [](WorldSettings& s) {
      s.threads = 4;
      s.adaptive_threads = false;
    });
  });
}

TEST(Allocation, NoneInFreeFlight) {
  World world;
  world.add_body(body_at(box_shape(Vec3::Ones()), Vec3::Zero()));
  run(world, 2);
  for (int step = 0; step < 100; ++step) EXPECT_EQ(allocations_of_a_step(world), 0);
}

TEST(Allocation, GrowthIsGeometric) {
  World world = falling_hulls(60, 32);
  run(world, 1);
  const int pairs_before = world.stats().pairs;
  int most_pairs = pairs_before;
  long total = 0;
  for (int step = 0; step < 300; ++step) {
    total += allocations_of_a_step(world);
    most_pairs = std::max(most_pairs, world.stats().pairs);
  }
  ASSERT_GT(most_pairs, 100);
  // Seven arrays of pairs, and as many that they are merged into, double at different steps. Arrays of contacts
  // and points grow with them. One allocation per pair and array would be thousands.
  constexpr int arrays = 30;
  EXPECT_LT(total, arrays * (1 + std::log2(Real(most_pairs) / Real(pairs_before))));
}

}  // namespace
}  // namespace cs550
