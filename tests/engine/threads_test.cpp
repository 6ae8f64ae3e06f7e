// Several threads leave the bits of one.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "cs550/scene.hpp"
#include "engine/four_threads.hpp"
#include "engine/pairs_of_contacts.hpp"
#include "engine/parts/body_parts.hpp"
#include "engine/test_bodies.hpp"
#include "engine/threads/thread_team.hpp"
#include "engine/threads/thread_trial.hpp"

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
  world.settings().adaptive_threads = false;
  for (int step = 0; step < steps; ++step) world.step(h);
  return world.state_hash();
}

void expect_equal_hashes(const World& world, Real h, int steps) {
  with_four_threads([&] {
    for (const Quality quality : {Quality::Accurate, Quality::Game}) {
      const std::uint64_t one = hash_after(world, quality, 1, h, steps);
      for (int threads = 2; threads <= 4; ++threads) {
        EXPECT_EQ(hash_after(world, quality, threads, h, steps), one)
            << threads << " threads, " << (quality == Quality::Game ? "game" : "accurate");
      }
    }
  });
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

/// Five by five towers of six boxes on a floor that may rise. On top of each lies a needle that will tip.
World towers(BodyKind kind_of_floor) {
  World world;
  BodyDef floor = floor_body();
  floor.kind = kind_of_floor;
  if (kind_of_floor == BodyKind::Kinematic) floor.linear_velocity = {0, 0, Real(0.2)};
  world.add_body(floor);
  const ShapePtr box = box_shape(Vec3::Constant(Real(0.25)));
  const ShapePtr needle = box_shape({Real(0.4), Real(0.01), Real(0.01)});
  for (int i = 0; i < 25; ++i) {
    const int column = i % 5;
    const int row = i / 5;
    const Vec3 foot = {Real(column), Real(row), 0};
    for (int story = 0; story < 6; ++story) {
      world.add_body(body_at(box, foot + Vec3{0, 0, Real(0.5) * Real(story) + Real(0.25)}));
    }
    world.add_body(body_at(needle, foot + Vec3{Real(0.3), Real(0.1), Real(3.01)}));
  }
  return world;
}

TEST(Threads, LeaveTheSameStateInTowersThatStandApart) {
  expect_equal_hashes(towers(BodyKind::Static), step_length, 40);
}

TEST(Threads, LeaveTheSameStateInTowersOnAFloorThatRises) {
  expect_equal_hashes(towers(BodyKind::Kinematic), step_length, 40);
}

/// Two blocks of cubes with a gap between them, and across it a needle that spins about its long axis.
World needle_across_two_blocks() {
  World world;
  world.add_body(floor_body());
  const ShapePtr cube = box_shape(Vec3::Constant(Real(0.25)));
  for (int i = 0; i < 8 * 4 * 4; ++i) {
    const Vec3 place(Real(i % 8) - Real(3.5), Real(i / 8 % 4) - Real(1.5),
                     Real(i / 32) + Real(0.5));
    const Vec3 half_of_gap(std::copysign(Real(0.02), place.x()), 0, 0);
    world.add_body(body_at(cube, Real(0.5) * place + half_of_gap));
  }
  BodyDef needle =
      body_at(box_shape({Real(0.4), Real(0.01), Real(0.01)}), {0, Real(0.25), Real(2.01)});
  needle.angular_velocity = {60, 0, 0};
  world.add_body(needle);
  return world;
}

/// The parts of the bodies that touch a body at the start of its world's first step.
std::set<Index> parts_that_touch(World world, Index body) {
  const std::vector<RigidBody> bodies(world.bodies().begin(), world.bodies().end());
  world.step(step_length);
  const std::vector<Contact> contacts(world.contacts().begin(), world.contacts().end());
  BodyParts parts;
  divide_bodies(pairs_of(contacts), bodies, world.settings().gravity, parts);
  std::set<Index> touching;
  for (const Contact& contact : contacts) {
    if (contact.manifold.points.empty()) continue;
    if (contact.body_a == body) touching.insert(parts.of_body[contact.body_b]);
    if (contact.body_b == body) touching.insert(parts.of_body[contact.body_a]);
  }
  return touching;
}

// The needle turns by more than its thinness in a substep: the masses of its contacts change before the relax
// passes, too. Contact leaves it a quarter of its spin.
TEST(Threads, LeaveTheSameStateIfANeedleSpinsBetweenTwoParts) {
  const World world = needle_across_two_blocks();
  ASSERT_EQ(parts_that_touch(world, world.body_count() - 1).size(), 2U);
  expect_equal_hashes(world, step_length, 10);
}

// Side by side with a gap of a millimetre, the boxes push each other once they move.
TEST(Threads, LeaveTheSameStateInAWorldOfThreePartsLong) {
  constexpr int contacts_of_three_parts = 3 * 2048;  // see part_count()
  Random random(10);
  World world;
  world.add_body(floor_body());
  for (int i = 0; i < 17 * 17 * 8; ++i) {
    const Vec3 place(Real(i % 17), Real(i / 17 % 17), Real(i / (17 * 17)));
    BodyDef def = body_at(unit_box(), place.cwiseProduct(Vec3(Real(1.001), Real(1.001), 1)) +
                                          Vec3(-8, -8, Real(0.5)));
    def.linear_velocity = random.real(0, 1) * random.unit_vector();
    world.add_body(def);
  }
  expect_equal_hashes(world, step_length, 2);
  world.step(step_length);
  EXPECT_GE(world.stats().contacts, contacts_of_three_parts);
}

/// The boxes on top of every second tower were fixed, or missing, and come free between two divisions of the bodies.
/// The needles, which could lie across a cut between parts, are gone.
std::uint64_t hash_if_tops_come_free(int threads, bool missing) {
  World world = towers(BodyKind::Static);
  world.settings().threads = threads;
  world.settings().adaptive_threads = false;
  for (Index needle = 7; needle <= 7 * 25; needle += 7) world.remove_body(world.id_at(needle));
  std::vector<BodyDef> free_tops;
  std::vector<BodyId> tops;
  for (Index top = 6; top <= 7 * 25; top += 14) {
    const BodyId id = world.id_at(top);
    BodyDef fixed = world.definition(id);
    free_tops.push_back(fixed);
    tops.push_back(id);
    fixed.kind = BodyKind::Static;
    world.redefine_body(id, fixed);
    if (missing) world.remove_body(id);
  }
  for (int step = 0; step < 12; ++step) {
    for (std::size_t i = 0; step == 5 && i < tops.size(); ++i) {
      if (missing) {
        world.add_body(free_tops[i]);
      } else {
        world.redefine_body(tops[i], free_tops[i]);
      }
    }
    world.step(step_length);
  }
  return world.state_hash();
}

TEST(Threads, LeaveTheSameStateIfBodiesComeFree) {
  with_four_threads([] {
    for (const bool missing : {false, true}) {
      const std::uint64_t one = hash_if_tops_come_free(1, missing);
      for (int threads = 2; threads <= 4; ++threads) {
        EXPECT_EQ(hash_if_tops_come_free(threads, missing), one)
            << threads << " threads, " << (missing ? "added" : "redefined");
      }
    }
  });
}

TEST(Threads, MayChangeBetweenSteps) {
  World alternating = falling_hulls(20, 8);
  alternating.settings().adaptive_threads = false;
  World single = alternating;
  with_four_threads([&] {
    for (int step = 0; step < 60; ++step) {
      alternating.settings().threads = 1 + step % 4;
      alternating.step(step_length);
      single.step(step_length);
      ASSERT_EQ(alternating.state_hash(), single.state_hash()) << "step " << step;
    }
  });
}

TEST(Threads, LeaveTheSameStateIfTheWorldChoosesThem) {
  World adaptive = falling_hulls(20, 8);
  World single = adaptive;
  adaptive.settings().threads = 2;
  for (int step = 0; step < 60; ++step) {
    adaptive.step(step_length);
    single.step(step_length);
    ASSERT_EQ(adaptive.state_hash(), single.state_hash()) << "step " << step;
  }
}

/// Steps that take these times (s).
struct StepTimes {
  double shared = 0;
  double alone = 0;
};

/// How many of the next steps the threads share.
int shared_steps(ThreadTrial& trial, int steps, const StepTimes& times) {
  int shared = 0;
  for (int step = 0; step < steps; ++step) {
    const bool shares = trial.shares_next_step();
    trial.note(shares ? times.shared : times.alone);
    if (shares) ++shared;
  }
  return shared;
}

// Three of the six steps of a trial go the slower way. Trials begin every 6 + 128 steps if the threads win, and every
// 6 + 32 if they lose: 8 and 27 times in 1,000 steps.
TEST(ThreadTrial, LeavesOnlyFewStepsToTheSlowerWay) {
  ThreadTrial fast_team;
  EXPECT_EQ(shared_steps(fast_team, 1000, {.shared = 1, .alone = 2}), 1000 - 3 * 8);
  ThreadTrial slow_team;
  EXPECT_EQ(shared_steps(slow_team, 1000, {.shared = 2, .alone = 1}), 3 * 27);
}

TEST(ThreadTrial, FollowsATimeThatChanges) {
  constexpr int longest_wait = 128 + 6;
  ThreadTrial trial;
  shared_steps(trial, 1000, {.shared = 2, .alone = 1});
  shared_steps(trial, longest_wait, {.shared = 1, .alone = 2});
  EXPECT_GE(shared_steps(trial, 100, {.shared = 1, .alone = 2}), 97);
  shared_steps(trial, longest_wait, {.shared = 2, .alone = 1});
  EXPECT_LE(shared_steps(trial, 100, {.shared = 2, .alone = 1}), 3 * 3);
}

// Of the steps of a trial, the first of each kind takes longer, and something else may delay one of the others.
TEST(ThreadTrial, ComparesTheFastestSteps) {
  ThreadTrial trial;
  for (const double seconds : {9.0, 8.0, 1.0}) {
    ASSERT_TRUE(trial.shares_next_step());
    trial.note(seconds);
  }
  for (const double seconds : {0.5, 2.0, 7.0}) {  // 0.5: the first of its kind does not count
    ASSERT_FALSE(trial.shares_next_step());
    trial.note(seconds);
  }
  EXPECT_TRUE(trial.shares_next_step());
}

}  // namespace
}  // namespace cs550::test
