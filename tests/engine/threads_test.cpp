// Several threads leave the bits of one.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include "cs550/scene.hpp"
#include "engine/test_bodies.hpp"
#include "engine/threads/thread_team.hpp"

namespace cs550::test {
namespace {

TEST(ThreadTeam, VisitsEveryNumberOfALoopOnce) {
  for (int threads = 1; threads <= 5; ++threads) {
    ThreadTeam team(threads);
    team.run([&] {
      for (std::size_t count = 0; count < 200; ++count) {
        const std::size_t block = 1 + count % 7;
        std::vector<std::atomic<int>> visits(count);
        team.for_blocks(count, block, [&](std::size_t first, std::size_t last) {
          EXPECT_LE(last - first, block);
          for (std::size_t i = first; i < last; ++i) ++visits[i];
        });
        for (const std::atomic<int>& number : visits) ASSERT_EQ(number, 1);
      }
    });
  }
}

TEST(ThreadTeam, FinishesWithoutWorkers) {
  ThreadTeam team(4);  // workers exist only during run()
  std::atomic<int> sum = 0;
  team.for_blocks(100, 3, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) sum += static_cast<int>(i);
  });
  EXPECT_EQ(sum, 99 * 100 / 2);
}

// Eight threads are more than most machines have processors: some wait for one, and come back when other loops
// have begun.
TEST(ThreadTeam, KeepsLoopsApartIfWorkersAreLate) {
  constexpr std::size_t most = 32;
  for (const int threads : {2, 3, 8}) {
    ThreadTeam team(threads);
    team.run([&] {
      for (std::size_t loop = 0; loop < 20'000; ++loop) {
        const std::size_t count = 2 + loop % (most - 1);
        std::array<std::atomic<int>, most> visits{};
        team.for_blocks(count, 1 + loop % 3, [&](std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) ++visits[i];
        });
        for (std::size_t i = 0; i < most; ++i) ASSERT_EQ(visits[i], i < count ? 1 : 0);
      }
    });
  }
}

TEST(ThreadTeam, ReportsTheFailureOfTheFirstBlock) {
  ThreadTeam team(3);
  team.run([&] {
    for (int round = 0; round < 50; ++round) {
      std::string message;
      try {
        team.for_blocks(90, 10, [](std::size_t first, std::size_t) {
          if (first >= 20) throw std::runtime_error(std::to_string(first));
        });
      } catch (const std::runtime_error& error) {
        message = error.what();
      }
      ASSERT_EQ(message, "20");
    }
  });
}

std::uint64_t hash_after(World world, Quality quality, int threads, Real h, int steps) {
  set_quality(world.settings(), quality);
  world.settings().threads = threads;
  for (int step = 0; step < steps; ++step) world.step(h);
  return world.state_hash();
}

void expect_equal_hashes(const World& world, Real h, int steps) {
  for (const Quality quality : {Quality::Accurate, Quality::Game}) {
    const std::uint64_t one = hash_after(world, quality, 1, h, steps);
    for (int threads = 2; threads <= 4; ++threads) {
      EXPECT_EQ(hash_after(world, quality, threads, h, steps), one)
          << threads << " threads, " << (quality == Quality::Game ? "game" : "accurate");
    }
  }
}

TEST(Threads, LeaveTheSameStateInEveryShippedSceneLong) {
  for (const std::string& name : shipped_scenes()) {
    SCOPED_TRACE(name);
    const SceneResult found = find_scene(name);
    ASSERT_TRUE(found) << found.error;
    expect_equal_hashes(make_world(found.scene), found.scene.h, 25);
  }
}

TEST(Threads, LeaveTheSameStateInAPileThatFallsAsleep) {
  World world = falling_hulls(40, 7);
  world.settings().sleeping = true;
  expect_equal_hashes(world, step_length, 60);
}

TEST(Threads, MayChangeBetweenSteps) {
  World alternating = falling_hulls(20, 8);
  World single = alternating;
  for (int step = 0; step < 60; ++step) {
    alternating.settings().threads = 1 + step % 3;
    alternating.step(step_length);
    single.step(step_length);
    ASSERT_EQ(alternating.state_hash(), single.state_hash()) << "step " << step;
  }
}

}  // namespace
}  // namespace cs550::test
