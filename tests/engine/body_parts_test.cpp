// The parts of a world: where they are cut, and that threads may solve them at the same time.
#include "engine/parts/body_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "engine/contacts/solve_order.hpp"
#include "engine/pairs_of_contacts.hpp"
#include "helpers/random.hpp"

namespace cs550::test {
namespace {

const Vec3 down(0, 0, Real(-9.81));

/// Bodies and the contacts between them. The first body is an immovable floor.
struct Heap {
  std::vector<RigidBody> bodies = std::vector<RigidBody>(1);
  std::vector<Contact> contacts;

  Heap() { bodies[0].kind = BodyKind::Static; }

  Index add(const Vec3& position) {
    bodies.emplace_back().pose.position = position;
    return static_cast<Index>(bodies.size()) - 1;
  }
  void touch(Index a, Index b) {
    Contact& contact = contacts.emplace_back();
    contact.body_a = std::min(a, b);
    contact.body_b = std::max(a, b);
    contact.manifold.points.push_back({});
  }
  BodyParts parts(const Vec3& gravity = down) const {
    BodyParts parts;
    divide_bodies(pairs_of(contacts), bodies, gravity, parts);
    return parts;
  }
};

/// Cubes that touch their neighbours along all three axes, and the floor.
Heap grid(Index nx, Index ny, Index nz) {
  Heap heap;
  const auto at = [&](Index x, Index y, Index z) { return 1 + x + nx * (y + ny * z); };
  for (Index z = 0; z < nz; ++z) {
    for (Index y = 0; y < ny; ++y) {
      for (Index x = 0; x < nx; ++x) heap.add(Vec3(Real(x), Real(y), Real(z)));
    }
  }
  for (Index z = 0; z < nz; ++z) {
    for (Index y = 0; y < ny; ++y) {
      for (Index x = 0; x < nx; ++x) {
        if (x + 1 < nx) heap.touch(at(x, y, z), at(x + 1, y, z));
        if (y + 1 < ny) heap.touch(at(x, y, z), at(x, y + 1, z));
        if (z + 1 < nz) heap.touch(at(x, y, z), at(x, y, z + 1));
        if (z == 0) heap.touch(0, at(x, y, z));
      }
    }
  }
  return heap;
}

/// Of the contacts: how many are inside each part, and how many are between parts.
struct Counts {
  std::vector<Index> inside;
  Index between = 0;
};

Counts count(const Heap& heap, const BodyParts& parts) {
  Counts counts{std::vector<Index>(parts.count)};
  for (const Contact& contact : heap.contacts) {
    const Index b = parts.of_body[contact.body_b];
    const Index a = contact.body_a == 0 ? b : parts.of_body[contact.body_a];
    if (a == b) {
      ++counts.inside[a];
    } else {
      ++counts.between;
    }
  }
  return counts;
}

TEST(BodyParts, FewContactsAreOnePart) {
  const Heap heap = grid(3, 3, 3);
  const BodyParts parts = heap.parts();
  EXPECT_EQ(parts.count, 1);
  EXPECT_EQ(parts.of_body, std::vector<Index>(heap.bodies.size(), 0));
}

TEST(BodyParts, ACutOfABlockOfCubesCrossesItsShortestRow) {
  const Heap heap = grid(20, 5, 4);
  const BodyParts parts = heap.parts();
  ASSERT_EQ(parts.count, 2);
  const Counts counts = count(heap, parts);
  EXPECT_EQ(counts.between, 5 * 4) << "one contact for each cube of a plane across x";
  EXPECT_EQ(counts.inside[0], counts.inside[1]) << "in the middle";
}

TEST(BodyParts, ManyContactsHaveAPartForEachOfEightThreads) {
  const Heap heap = grid(64, 16, 8);
  const BodyParts parts = heap.parts();
  ASSERT_EQ(parts.count, most_parts);
  const Counts counts = count(heap, parts);
  EXPECT_EQ(counts.between, 7 * 16 * 8);
  const auto [fewest, most] = std::minmax_element(counts.inside.begin(), counts.inside.end());
  // Seven planes cut a row of 64 cubes; the quantiles of the contacts are half a cube from them at most.
  EXPECT_LE(*most - *fewest, 2 * 16 * 8 * 3);
}

TEST(BodyParts, AreNeverAboveEachOther) {
  const Heap heap = grid(4, 4, 30);  // a cut across z would cross the fewest contacts
  const BodyParts parts = heap.parts();
  ASSERT_EQ(parts.count, 2);
  const Counts counts = count(heap, parts);
  EXPECT_GT(std::min(counts.inside[0], counts.inside[1]), 0) << "no part is empty";
  for (Index column = 0; column < 4 * 4; ++column) {
    for (Index z = 1; z < 30; ++z) {
      EXPECT_EQ(parts.of_body[1 + column], parts.of_body[1 + column + 4 * 4 * z]);
    }
  }
  const BodyParts weightless = heap.parts(Vec3::Zero());
  EXPECT_EQ(count(heap, weightless).between, 4 * 4) << "without gravity across z, too";
}

TEST(BodyParts, SeparateHeapsAreNotCut) {
  for (const int axis : {0, 1}) {
    Heap heap;
    Random random(5);
    for (const Real side : {Real(-1), Real(1)}) {
      std::vector<Index> near;
      for (int i = 0; i < 60; ++i) {
        Vec3 position = random.point_in_box(Vec3::Constant(3));
        position[axis] += 4 * side;
        near.push_back(heap.add(position));
      }
      for (int i = 0; i < 100; ++i) {
        const Index a = near[random.integer(0, 59)];
        const Index b = near[random.integer(0, 59)];
        if (a != b) heap.touch(a, b);
      }
    }
    const BodyParts parts = heap.parts();
    ASSERT_EQ(parts.count, 2);
    EXPECT_EQ(count(heap, parts).between, 0) << "axis " << axis;
    EXPECT_NE(parts.of_body[1], parts.of_body[61]);
  }
}

/// Boxes on boxes on the floor, in five by five towers.
Heap towers(Index boxes) {
  Heap heap;
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 5; ++y) {
      Index below = 0;
      for (Index z = 0; z < boxes; ++z) {
        const Index box = heap.add(Vec3(Real(3 * x), Real(3 * y), Real(z)));
        heap.touch(below, box);
        below = box;
      }
    }
  }
  return heap;
}

TEST(BodyParts, ACutBetweenTowersMayBeOblique) {
  constexpr Index boxes = 10;
  const Heap heap = towers(boxes);
  const BodyParts parts = heap.parts();
  ASSERT_EQ(parts.count, 2);
  const Counts counts = count(heap, parts);
  EXPECT_EQ(counts.between, 0);
  EXPECT_EQ(std::min(counts.inside[0], counts.inside[1]), 12 * boxes)
      << "a straight cut leaves ten towers on one side";
  EXPECT_EQ(parts.direction.z(), 0) << "bodies stay with what they rest on";
}

TEST(BodyParts, PositionsThatAreNotNumbersHaveAPart) {
  Heap heap = grid(20, 5, 4);
  heap.bodies[3].pose.position.setConstant(std::numeric_limits<Real>::quiet_NaN());
  heap.bodies[9].pose.position.setConstant(std::numeric_limits<Real>::infinity());
  heap.bodies[12].pose.position = Vec3(-std::numeric_limits<Real>::infinity(), 0, 0);
  const BodyParts parts = heap.parts();
  for (const Index part : parts.of_body) {
    EXPECT_GE(part, 0);
    EXPECT_LT(part, parts.count);
  }
}

TEST(BodyParts, AreKeptForSixteenSteps) {
  Heap heap = grid(20, 5, 4);
  const PairList pairs = pairs_of(heap.contacts);
  BodyParts parts;
  divide_bodies(pairs, heap.bodies, down, parts);
  const std::vector<Index> first = parts.of_body;
  for (RigidBody& body : heap.bodies) body.pose.position.x() *= -1;  // the last are now the first
  for (int step = 1; step < 16; ++step) {
    divide_bodies(pairs, heap.bodies, down, parts);
    ASSERT_EQ(parts.of_body, first) << "step " << step;
  }
  divide_bodies(pairs, heap.bodies, down, parts);
  EXPECT_NE(parts.of_body, first);
}

TEST(BodyParts, ComeAboutInTheStepThatHasEnoughContacts) {
  const Heap heap = grid(20, 5, 4);
  BodyParts parts;
  divide_bodies(pairs_of({}), heap.bodies, down, parts);
  ASSERT_EQ(parts.count, 1);
  divide_bodies(pairs_of(heap.contacts), heap.bodies, down, parts);
  EXPECT_EQ(parts.count, 2);
}

/// Contacts between random bodies in random parts.
struct DividedHeap {
  Heap heap;
  BodyParts parts;

  explicit DividedHeap(Random& random) {
    parts.count = random.integer(2, most_parts);
    for (int i = 0; i < 100; ++i) heap.add(Vec3::Zero());
    heap.bodies.back().kind = BodyKind::Kinematic;
    for (std::size_t i = 0; i < heap.bodies.size(); ++i) {
      parts.of_body.push_back(random.integer(0, parts.count - 1));
    }
    for (int i = 0; i < 300; ++i) {
      const Index a = random.integer(0, 100);
      const Index b = random.integer(0, 100);
      const bool movable = is_movable(a) || is_movable(b);
      if (a == b || !movable) continue;
      heap.touch(a, b);
      heap.contacts.back().manifold.normal = random.unit_vector();
    }
  }
  bool is_movable(Index body) const { return heap.bodies[body].kind == BodyKind::Dynamic; }
};

TEST(SolveUnits, OfAPhaseShareNoMovableBody) {
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const DividedHeap divided(random);
    ThreadTeam team(2);
    SolveOrder order;
    arrange_constraints(pairs_of(divided.heap.contacts), divided.heap.bodies, down, order,
                        divided.parts, &team);
    ASSERT_GT(order.units.size(), 1U);
    std::multiset<Index> visited;
    for (std::size_t phase = 0; phase < phase_count; ++phase) {
      std::vector<std::size_t> unit_of_body(divided.heap.bodies.size(), order.units.size());
      for (std::size_t unit = order.phases[phase]; unit < order.phases[phase + 1]; ++unit) {
        for (const ContactGroup& group : order.units[unit].groups) {
          for (const Index i : group) {
            visited.insert(i);
            const Contact& contact = divided.heap.contacts[i];
            for (const Index body : {contact.body_a, contact.body_b}) {
              if (!divided.is_movable(body)) continue;
              EXPECT_TRUE(unit_of_body[body] == unit || unit_of_body[body] == order.units.size());
              unit_of_body[body] = unit;
            }
          }
        }
      }
    }
    EXPECT_EQ(visited.size(), divided.heap.contacts.size()) << "each contact is in one unit";
    EXPECT_EQ(std::set<Index>(visited.begin(), visited.end()).size(), visited.size());
  }
}

/// For each movable body, its contacts in the order in which they are solved.
std::vector<std::vector<Index>> order_by_body(const DividedHeap& divided, const SolveOrder& order) {
  std::vector<std::vector<Index>> contacts(divided.heap.bodies.size());
  for (const SolveUnit& unit : order.units) {
    for (const ContactGroup& group : unit.groups) {
      for (const Index i : group) {
        const Contact& contact = divided.heap.contacts[i];
        for (const Index body : {contact.body_a, contact.body_b}) {
          if (divided.is_movable(body)) contacts[body].push_back(i);
        }
      }
    }
  }
  return contacts;
}

TEST(SolveUnits, LeaveEachBodyTheOrderOfOneThread) {
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const DividedHeap divided(random);
    const PairList pairs = pairs_of(divided.heap.contacts);
    ThreadTeam team(3);
    SolveOrder shared;
    SolveOrder alone;
    arrange_constraints(pairs, divided.heap.bodies, down, shared, divided.parts, &team);
    arrange_constraints(pairs, divided.heap.bodies, down, alone, divided.parts);
    ASSERT_EQ(alone.units.size(), 1U);
    EXPECT_EQ(shared.contacts, alone.contacts);
    EXPECT_EQ(order_by_body(divided, shared), order_by_body(divided, alone));
  }
}

TEST(SolveUnits, AreThoseOfTheseThreadsIfTheOrderIsUsedAgain) {
  Random random(1);
  const DividedHeap divided(random);
  const PairList pairs = pairs_of(divided.heap.contacts);
  ThreadTeam team(2);
  SolveOrder used;
  for (ThreadTeam* const present : {&team, static_cast<ThreadTeam*>(nullptr), &team}) {
    SolveOrder fresh;
    arrange_constraints(pairs, divided.heap.bodies, down, used, divided.parts, present);
    arrange_constraints(pairs, divided.heap.bodies, down, fresh, divided.parts, present);
    EXPECT_EQ(used.place_of_point, fresh.place_of_point);
    EXPECT_EQ(used.phases, fresh.phases);
    ASSERT_EQ(used.units.size(), fresh.units.size());
    for (std::size_t i = 0; i < used.units.size(); ++i) {
      EXPECT_EQ(used.units[i].first_place, fresh.units[i].first_place);
      EXPECT_EQ(used.units[i].end_place, fresh.units[i].end_place);
      EXPECT_EQ(used.units[i].groups.size(), fresh.units[i].groups.size());
    }
  }
}

/// Bricks that rest on two of the row below, and do not touch the others of their row.
Heap brick_wall(Index width, Index rows) {
  Heap heap;
  const auto at = [&](Index x, Index row) { return 1 + x + width * row; };
  for (Index row = 0; row < rows; ++row) {
    for (Index x = 0; x < width; ++x) {
      heap.add(Vec3(Real(x) + Real(0.5) * Real(row % 2), 0, Real(row)));
    }
  }
  for (Index row = 1; row < rows; ++row) {
    for (Index x = 0; x < width; ++x) {
      const Index other = row % 2 == 1 ? x + 1 : x - 1;
      for (const Index below : {x, other}) {
        if (below < 0 || below >= width) continue;
        heap.touch(at(below, row - 1), at(x, row));
        heap.contacts.back().manifold.normal = Vec3::UnitZ();
      }
    }
  }
  return heap;
}

// The contacts across a cut through a brick wall form one path from the bottom to the top. The edges of a
// path have two colours, so half of its contacts can be solved at a time, not one.
TEST(SolveUnits, SolveWhatIsBetweenPartsSideBySide) {
  const Heap wall = brick_wall(16, 17);
  const BodyParts parts = wall.parts();
  ASSERT_EQ(parts.count, 2);
  ThreadTeam team(2);
  SolveOrder order;
  arrange_constraints(pairs_of(wall.contacts), wall.bodies, down, order, parts, &team);
  ASSERT_GT(order.units.size(), 2U);
  const SolveUnit& between = order.units[2];
  const Index contacts = between.end_contact - between.first_contact;
  EXPECT_GE(contacts, 16) << "at least one for each row above the first";
  const Index of_each_colour = (contacts + 1) / 2;
  const Index groups_of_each = (of_each_colour + lane_count - 1) / static_cast<Index>(lane_count);
  EXPECT_LE(between.groups.size(), static_cast<std::size_t>(2 * groups_of_each));
}

}  // namespace
}  // namespace cs550::test
