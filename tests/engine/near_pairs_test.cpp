// The list of near pairs against a search through all pairs of boxes, and edits of a list against a plain one.
#include "engine/pairs/near_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "cs550/primitives.hpp"
#include "engine/pairs/pair_list.hpp"
#include "engine/test_bodies.hpp"
#include "helpers/random.hpp"

namespace cs550::test {
namespace {

using BodyPair = std::pair<Index, Index>;

std::vector<BodyPair> listed_pairs(const PairList& pairs) {
  std::vector<BodyPair> listed;
  for (const PairSummary& pair : pairs.summaries) listed.emplace_back(pair.body_a, pair.body_b);
  return listed;
}

/// Bodies that are moved by hand. Every third is immovable.
struct Crowd {
  WorldState world;
  ShapePtr shape = box_shape(Vec3::Ones());

  void add(const Vec3& position) {
    BodyDef def = body_at(shape, position);
    if (world.slots.size() % 3 == 2) def.kind = BodyKind::Static;
    RigidBody body;
    body.kind = def.kind;
    body.pose = def.pose;
    world.bodies.push_back(body);
    world.definitions.push_back(def);
    world.slots.emplace_back().alive = true;
    insert_leaf(world, static_cast<Index>(world.slots.size()) - 1);
  }
  void remove(Index body) {
    std::vector<char> leaving(world.slot_count());
    leaving[body] = 1;
    remove_pairs_of(world, leaving);
    world.tree.remove(world.slots[body].leaf);
    world.slots[body].alive = false;
  }
  bool are_near(Index a, Index b) const {
    const bool both_immovable =
        world.bodies[a].kind == BodyKind::Static && world.bodies[b].kind == BodyKind::Static;
    return world.slots[a].alive && world.slots[b].alive && !both_immovable &&
           world.tree.bounds(world.slots[a].leaf).overlaps(world.tree.bounds(world.slots[b].leaf));
  }
  bool boxes_contain_bodies() const {
    for (Index i = 0; i < static_cast<Index>(world.slots.size()); ++i) {
      const Bounds bounds = world_bounds(world.posed_shape(i));
      const BodySlot& slot = world.slots[i];
      if (slot.alive && !world.tree.bounds(slot.leaf).contains(bounds)) return false;
    }
    return true;
  }
  std::vector<BodyPair> near_pairs() const {
    std::vector<BodyPair> near;
    const auto count = static_cast<Index>(world.slots.size());
    for (Index a = 0; a < count; ++a) {
      for (Index b = a + 1; b < count; ++b) {
        if (are_near(a, b)) near.emplace_back(a, b);
      }
    }
    return near;
  }
};

TEST(NearPairs, AreThoseWhoseBoxesOverlap) {
  Random random(1);
  Crowd crowd;
  for (int i = 0; i < 60; ++i) crowd.add(random.point_in_box(Vec3::Constant(4)));
  std::size_t listed = 0;
  std::size_t changes = 0;
  std::vector<BodyPair> before;
  for (int step = 0; step < 300; ++step) {
    for (RigidBody& body : crowd.world.bodies) {
      if (random.integer(0, 3) > 0) continue;
      body.pose.position += random.real(0, Real(0.2)) * random.unit_vector();
    }
    if (step % 50 == 20) crowd.remove(static_cast<Index>(step / 10));
    if (step % 50 == 30) crowd.add(random.point_in_box(Vec3::Constant(4)));
    update_pairs(crowd.world, step_length);
    const std::vector<BodyPair> pairs = listed_pairs(crowd.world.pairs);
    ASSERT_EQ(pairs, crowd.near_pairs()) << "step " << step;
    ASSERT_TRUE(crowd.boxes_contain_bodies()) << "step " << step;
    listed += pairs.size();
    if (pairs != before) ++changes;
    before = pairs;
    if (step % 2 == 0) enclose_bodies(crowd.world);
  }
  EXPECT_GT(listed, 300U * 50U);
  EXPECT_GT(changes, 200U);
}

/// Moves bodies by their velocities, and lists their pairs.
void fly(WorldState& world) {
  for (RigidBody& body : world.bodies) {
    body.pose.position += step_length * body.linear_velocity;
  }
  update_pairs(world, step_length);
}

TEST(NearPairs, IncludeThoseWhoseSweptBoundsOverlap) {
  Random random(3);
  Crowd crowd;
  WorldState& world = crowd.world;
  for (int i = 0; i < 60; ++i) crowd.add(random.point_in_box(Vec3::Constant(6)));
  std::size_t overlapping = 0;
  for (int step = 0; step < 300; ++step) {
    for (RigidBody& body : world.bodies) {
      const bool turns = body.kind == BodyKind::Dynamic && random.integer(0, 9) == 0;
      if (turns) body.linear_velocity = random.real(0, 20) * random.unit_vector();
      if (body.pose.position.norm() > 12) body.pose.position.setZero();
    }
    fly(world);
    const std::vector<BodyPair> listed = listed_pairs(world.pairs);
    for (Index a = 0; a < 60; ++a) {
      for (Index b = a + 1; b < 60; ++b) {
        const bool both_immovable = a % 3 == 2 && b % 3 == 2;
        if (both_immovable) continue;
        if (!world.slots[a].swept_bounds.overlaps(world.slots[b].swept_bounds)) continue;
        ++overlapping;
        ASSERT_TRUE(std::binary_search(listed.begin(), listed.end(), BodyPair(a, b)))
            << "bodies " << a << " and " << b << " in step " << step;
      }
    }
  }
  EXPECT_GT(overlapping, 300U * 20U);
}

/// Each box is stored with room for what comes, but only where its body goes.
TEST(NearPairs, AreNotBodiesThatFallSideBySide) {
  Crowd crowd;
  constexpr Real gap = Real(0.3);
  for (int i = 0; i < 12; ++i) crowd.add({(2 + gap) * Real(i), 0, 0});
  for (RigidBody& body : crowd.world.bodies) body.linear_velocity = {0, 0, -5};
  for (int step = 0; step < 30; ++step) {
    fly(crowd.world);
    ASSERT_EQ(crowd.world.pairs.size(), 0U) << "step " << step;
  }
}

/// A stored box reaches two steps ahead, so that it need not be replaced in each.
TEST(NearPairs, TheBoxOfAFastBodyStaysForTwoSteps) {
  for (const Real speed : {Real(5), Real(10), Real(50)}) {
    Crowd crowd;
    crowd.add(Vec3::Zero());
    crowd.world.bodies[0].linear_velocity = {speed, 0, 0};
    const auto stored = [&] { return crowd.world.tree.bounds(crowd.world.slots[0].leaf); };
    int changes = 0;
    for (int step = 0; step < 60; ++step) {
      const Bounds before = stored();
      fly(crowd.world);
      changes += static_cast<int>(stored().lower != before.lower);
    }
    EXPECT_LE(changes, 21) << speed << " m/s";
  }
}

/// A box that was stored for a fast body would make pairs of all its neighbours.
TEST(NearPairs, TheBoxOfABodyThatHasStoppedShrinks) {
  Crowd crowd;
  crowd.add(Vec3::Zero());
  RigidBody& body = crowd.world.bodies[0];
  body.linear_velocity = {50, 0, 0};
  fly(crowd.world);
  body.linear_velocity.setZero();
  fly(crowd.world);
  const Bounds& stored = crowd.world.tree.bounds(crowd.world.slots[0].leaf);
  const Vec3 room = stored.extent() - world_bounds(crowd.world.posed_shape(0)).extent();
  EXPECT_LT(room.maxCoeff(), Real(0.1));
}

TEST(NearPairs, KeepTheirImpulsesWhileOthersComeAndGo) {
  Random random(2);
  Crowd crowd;
  for (int i = 0; i < 60; ++i) crowd.add(random.point_in_box(Vec3::Constant(4)));
  update_pairs(crowd.world, step_length);
  std::map<BodyPair, double> marks;  // energies, which are zero for new pairs
  for (int step = 1; step < 200; ++step) {
    PairList& pairs = crowd.world.pairs;
    marks.clear();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const PairSummary& pair = pairs.summaries[i];
      pairs.impulse_energy[i] = 1000 * step + static_cast<double>(i);
      pairs.contacts[i].friction = static_cast<Real>(pairs.impulse_energy[i]);
      marks[{pair.body_a, pair.body_b}] = pairs.impulse_energy[i];
    }
    for (RigidBody& body : crowd.world.bodies) {
      body.pose.position += random.real(0, Real(0.1)) * random.unit_vector();
    }
    update_pairs(crowd.world, step_length);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const PairSummary& pair = pairs.summaries[i];
      const auto old = marks.find({pair.body_a, pair.body_b});
      ASSERT_EQ(pairs.impulse_energy[i], old == marks.end() ? 0 : old->second);
      ASSERT_EQ(pairs.contacts[i].body_a, pair.body_a);
      ASSERT_EQ(pairs.contacts[i].body_b, pair.body_b);
      if (old == marks.end()) continue;
      ASSERT_EQ(pairs.contacts[i].friction, old->second);
    }
  }
}

TEST(NearPairs, ABodyInThePlaceOfASmallerOneHasItsOwnBounds) {
  World world;
  const BodyId small = world.add_body(body_at(box_shape(Vec3::Constant(Real(0.1))), Vec3::Zero()));
  world.step(step_length);
  const Vec3 center = world.body(small).pose.position;
  world.remove_body(small);
  world.add_body(body_at(box_shape(Vec3::Ones()), center));
  world.add_body(body_at(box_shape(Vec3::Ones()), center + Vec3(Real(1.9), 0, 0)));
  world.step(step_length);
  EXPECT_EQ(world.contacts().size(), 1U);
}

TEST(PairListEdit, DoesWhatChangesOneByOneDo) {
  Random random(3);
  PairList pairs;
  std::vector<Index> plain;
  for (int round = 0; round < 500; ++round) {
    std::vector<Index> changed;
    PairListEdit edit(pairs);
    // In some rounds more go than come, in others more come.
    const int often = random.integer(1, 5);
    for (std::size_t i = 0; i <= plain.size(); ++i) {
      while (plain.size() < 200 && random.integer(0, 6) < often) {
        const Index body = random.integer(0, 1'000'000);
        edit.insert(i, pair_key(body, body + 1));
        changed.push_back(body);
        if (random.integer(0, 1) == 0) break;
      }
      if (i == plain.size()) break;
      if (random.integer(0, 6) > often) {
        edit.drop(i);
      } else {
        changed.push_back(plain[i]);
      }
    }
    edit.apply();
    plain = changed;
    ASSERT_EQ(pairs.size(), plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i) {
      ASSERT_EQ(pairs.contacts[i].body_a, plain[i]) << "round " << round;
      ASSERT_EQ(pairs.summaries[i].body_a, plain[i]);
      ASSERT_EQ(pairs.summaries[i].body_b, plain[i] + 1);
    }
    ASSERT_EQ(pairs.misplaced.size(), plain.size());
  }
}

}  // namespace
}  // namespace cs550::test
