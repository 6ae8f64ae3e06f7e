// The order of the constraints: the same bits as in the order of the contacts, and no shared body
// in a group.
#include "engine/contacts/solve_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "engine/contacts/contact_constraints.hpp"
#include "engine/pairs_of_contacts.hpp"
#include "engine/world/stages.hpp"
#include "helpers/random.hpp"

namespace cs550::test {
namespace {

std::vector<RigidBody> bodies_of_kinds(Index movable, Index immovable) {
  std::vector<RigidBody> bodies(movable + immovable);
  for (Index i = 0; i < movable; ++i) {
    bodies[i].kind = BodyKind::Dynamic;
  }
  for (Index i = movable; i < movable + immovable; ++i) {
    bodies[i].kind = BodyKind::Static;
  }
  return bodies;
}

Contact contact_between(Index a, Index b, Index points) {
  Contact contact;
  contact.body_a = a;
  contact.body_b = b;
  for (Index i = 0; i < points; ++i) contact.manifold.points.push_back({});
  return contact;
}

/// The contact of each constraint in this order; −1 for an empty place.
std::vector<int> contact_of_constraint(const std::vector<Contact>& contacts,
                                       const SolveOrder& order) {
  std::vector<int> owner(order.place_of_point.size(), -1);
  std::size_t point = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    for (Index k = 0; k < contacts[i].manifold.points.size(); ++k) {
      owner[order.place_of_point[point++]] = static_cast<int>(i);
    }
  }
  return owner;
}

TEST(SolveOrder, ConstraintsOfAMovableBodyKeepTheirOrder) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Index movable = random.integer(2, 60);
    const std::vector<RigidBody> bodies = bodies_of_kinds(movable, 3);
    std::vector<Contact> contacts;
    for (Index i = random.integer(0, 200); i > 0; --i) {
      const Index a = random.integer(0, movable - 1);
      const Index b = random.integer(0, movable + 2);
      if (a != b) contacts.push_back(contact_between(a, b, random.integer(0, 4)));
    }
    SolveOrder order;
    arrange_constraints(pairs_of(contacts), bodies, Vec3::Zero(), order);

    std::vector<Index> last_constraint(movable, no_index);
    std::size_t point = 0;
    for (const Contact& contact : contacts) {
      for (Index k = 0; k < contact.manifold.points.size(); ++k) {
        const Index constraint = order.place_of_point[point++];
        for (const Index body : {contact.body_a, contact.body_b}) {
          if (body >= movable) continue;
          Index& last = last_constraint[body];
          ASSERT_LT(last, constraint) << "body " << body;
          last = constraint;
        }
      }
    }
    const std::vector<int> owners = contact_of_constraint(contacts, order);
    EXPECT_EQ(std::count(owners.begin(), owners.end(), -1), 0) << "every place is taken once";
  }
}

/// Checks that consecutive constraints that are solved side by side belong to different contacts.
void expect_full_lanes(const std::vector<Contact>& contacts, Index bodies_on_floor) {
  SolveOrder order;
  arrange_constraints(pairs_of(contacts), bodies_of_kinds(bodies_on_floor, 1), Vec3::Zero(), order);
  const std::vector<int> owners = contact_of_constraint(contacts, order);
  constexpr auto group_size = static_cast<std::size_t>(ContactGroup::capacity());
  ASSERT_EQ(owners.size() % group_size, 0U) << "the example fills all lanes";
  for (std::size_t first = 0; first < owners.size(); first += group_size) {
    for (std::size_t i = first; i < first + group_size; ++i) {
      for (std::size_t k = first; k < i; ++k) {
        EXPECT_NE(owners[i], owners[k]) << "constraints " << k << " and " << i;
      }
    }
  }
}

TEST(SolveOrder, BoxesOnOneFloorFillTheirGroups) {
  constexpr Index boxes = 2 * lane_count;
  std::vector<Contact> contacts;
  contacts.reserve(boxes);
  for (Index i = 0; i < boxes; ++i) contacts.push_back(contact_between(i, boxes, 4));
  expect_full_lanes(contacts, boxes);
}

TEST(SolveOrder, ContactsOfOnePointDoNotIdleBesideLongerOnes) {
  constexpr Index bodies = 2 * lane_count;
  std::vector<Contact> contacts;
  contacts.reserve(bodies);
  for (Index i = 0; i < bodies; ++i) {
    contacts.push_back(contact_between(i, bodies, i % 2 == 0 ? 1 : 4));
  }
  expect_full_lanes(contacts, bodies);
}

TEST(SolveOrder, ContactsWithMorePointsGoOnInTheFirstLanes) {
  const std::vector<RigidBody> bodies = bodies_of_kinds(3, 1);
  const std::vector<Contact> contacts{contact_between(0, 3, 3), contact_between(1, 3, 1),
                                      contact_between(2, 3, 2)};
  SolveOrder order;
  arrange_constraints(pairs_of(contacts), bodies, Vec3::Zero(), order);
  EXPECT_EQ(contact_of_constraint(contacts, order), (std::vector<int>{0, 2, 1, 0, 2, 0}));
}

/// The contacts of a wall on a floor: each box touches its neighbours in the row and rests on two boxes of the row
/// below. They are sorted by body A, then by body B, as the world sorts them.
std::vector<Contact> contacts_of_rows(Index rows, Index boxes) {
  std::vector<Contact> contacts;
  const auto touch = [&contacts](Index a, Index b, const Vec3& normal) {
    contacts.push_back(contact_between(a, b, 4));
    contacts.back().manifold.normal = normal;
  };
  for (Index box = 0; box < rows * boxes; ++box) {
    const Index place = box % boxes;
    if (place + 1 < boxes) touch(box, box + 1, Vec3::UnitX());
    if (box + boxes < rows * boxes) {
      if (place > 0) touch(box, box + boxes - 1, Vec3::UnitZ());
      touch(box, box + boxes, Vec3::UnitZ());
    }
    if (box < boxes) touch(box, rows * boxes, -Vec3::UnitZ());
  }
  return contacts;
}

TEST(SolveOrder, ContactsThatCarryWeightComeBeforeThoseOfNeighbours) {
  constexpr Index rows = 20;
  constexpr Index boxes = 20;
  const std::vector<Contact> contacts = contacts_of_rows(rows, boxes);
  const std::vector<RigidBody> bodies = bodies_of_kinds(rows * boxes, 1);
  SolveOrder order;
  arrange_constraints(pairs_of(contacts), bodies, Vec3(0, 0, Real(-9.81)), order);

  const auto carries_weight = [&](Index i) { return contacts[i].manifold.normal.z() != 0; };
  const auto first_neighbours =
      std::find_if_not(order.contacts.begin(), order.contacts.end(), carries_weight);
  EXPECT_TRUE(std::is_sorted(order.contacts.begin(), first_neighbours));
  EXPECT_TRUE(std::is_sorted(first_neighbours, order.contacts.end()));
  EXPECT_TRUE(std::none_of(first_neighbours, order.contacts.end(), carries_weight));

  std::vector<bool> neighbours_began(bodies.size());
  for (const int owner : contact_of_constraint(contacts, order)) {
    for (const Index body : {contacts[owner].body_a, contacts[owner].body_b}) {
      if (body == rows * boxes) continue;  // the floor waits for nobody
      EXPECT_FALSE(carries_weight(owner) && neighbours_began[body]) << "body " << body;
      neighbours_began[body] = !carries_weight(owner);
    }
  }

  SolveOrder weightless;
  arrange_constraints(pairs_of(contacts), bodies, Vec3::Zero(), weightless);
  EXPECT_TRUE(std::is_sorted(weightless.contacts.begin(), weightless.contacts.end()));
  EXPECT_LT(order.units[0].groups.size(), weightless.units[0].groups.size())
      << "the rows are no longer one chain";
}

TEST(SolveOrder, TowersFillTheirGroups) {
  constexpr Index towers = 25;
  constexpr Index boxes = 10;
  constexpr Index floor = towers * boxes;
  std::vector<Contact> contacts;
  for (Index box = 0; box < floor; ++box) {
    if (box % boxes == 0) contacts.push_back(contact_between(box, floor, 4));
    if (box % boxes != boxes - 1) contacts.push_back(contact_between(box, box + 1, 4));
  }
  SolveOrder order;
  arrange_constraints(pairs_of(contacts), bodies_of_kinds(floor, 1), Vec3::Zero(), order);
  // All towers at once need a group for each eight contacts, if none is left to be finished alone.
  EXPECT_EQ(order.units[0].groups.size(), (contacts.size() + lane_count - 1) / lane_count);
}

// Groups of single points alone would leave the tower for the end, with one contact in each group.
TEST(SolveOrder, ATowerIsSolvedBesideBoxesOnASingleCorner) {
  constexpr Index tower = 10;
  constexpr Index others = 80;
  constexpr Index floor = tower + others;
  std::vector<Contact> contacts;
  contacts.reserve(floor);
  for (Index box = 0; box < tower; ++box) {
    contacts.push_back(contact_between(box, box == 0 ? floor : box - 1, 4));
  }
  for (Index box = tower; box < floor; ++box) contacts.push_back(contact_between(box, floor, 1));
  SolveOrder order;
  arrange_constraints(pairs_of(contacts), bodies_of_kinds(floor, 1), Vec3::Zero(), order);
  // Each contact of the tower has a group of its own, whose other lanes the boxes fill.
  constexpr auto lanes = static_cast<Index>(lane_count);
  constexpr Index left = others - (lanes - 1) * tower;
  EXPECT_EQ(order.units[0].groups.size(), tower + (left + lanes - 1) / lanes);
}

TEST(SolveOrder, AnOrderThatIsUsedAgainIsThatOfTheseContacts) {
  const std::vector<RigidBody> bodies = bodies_of_kinds(3, 1);
  const std::vector<Contact> chain{contact_between(0, 3, 4), contact_between(0, 1, 2),
                                   contact_between(1, 2, 3)};
  std::vector<Contact> fewer_points = chain;
  fewer_points[1] = contact_between(0, 1, 1);
  std::vector<Contact> other_body = chain;
  other_body[2] = contact_between(2, 3, 3);
  std::vector<Contact> apart = chain;
  apart[0].manifold.points.clear();
  std::vector<Contact> one_more{contact_between(2, 3, 0)};
  one_more.insert(one_more.end(), chain.begin(), chain.end());
  std::vector<RigidBody> one_fixed = bodies;
  one_fixed[1].kind = BodyKind::Static;

  SolveOrder used;
  const auto expect_fresh = [&](const std::vector<Contact>& contacts,
                                const std::vector<RigidBody>& present) {
    SolveOrder fresh;
    arrange_constraints(pairs_of(contacts), present, Vec3::Zero(), fresh);
    arrange_constraints(pairs_of(contacts), present, Vec3::Zero(), used);
    EXPECT_EQ(used.place_of_point, fresh.place_of_point);
    EXPECT_EQ(used.first_point, fresh.first_point);
    EXPECT_EQ(used.contacts, fresh.contacts);
    ASSERT_EQ(used.units[0].groups.size(), fresh.units[0].groups.size());
    for (std::size_t i = 0; i < fresh.units[0].groups.size(); ++i) {
      EXPECT_TRUE(std::equal(used.units[0].groups[i].begin(), used.units[0].groups[i].end(),
                             fresh.units[0].groups[i].begin(), fresh.units[0].groups[i].end()));
    }
  };
  for (const auto& contacts :
       {chain, chain, fewer_points, other_body, apart, one_more, {}, chain}) {
    expect_fresh(contacts, bodies);
  }
  expect_fresh(chain, one_fixed);
  expect_fresh(chain, bodies);
}

/// A world whose contacts were dropped after they had been arranged.
WorldState world_without(const std::vector<Contact>& contacts) {
  WorldState world;
  world.bodies = bodies_of_kinds(2, 1);
  world.pairs = pairs_of(contacts);
  arrange_contacts(world);
  skip_stage(world, Stage::Solve, NotImplemented("L7.3"));
  return world;
}

TEST(SolveOrder, ContactsThatASkippedStageDroppedComeBack) {
  const std::vector<Contact> contacts{contact_between(0, 1, 4), contact_between(0, 2, 4)};
  WorldState world = world_without(contacts);
  EXPECT_TRUE(world.solve_order.contacts.empty());
  world.pairs = pairs_of(contacts);
  arrange_contacts(world);
  EXPECT_EQ(world.solve_order.contacts, (std::vector<Index>{0, 1}));
}

// The order of dropped contacts must not serve a step without any.
TEST(SolveOrder, OfDroppedContactsIsNotKept) {
  WorldState world = world_without({contact_between(0, 1, 4), contact_between(0, 2, 4)});
  arrange_contacts(world);
  EXPECT_TRUE(world.solve_order.place_of_point.empty());
  for (const SolveUnit& unit : world.solve_order.units) EXPECT_TRUE(unit.groups.empty());
}

// If L1.5 is unwritten, nothing else gathers the velocities that the solver's changes are compared with.
TEST(SolveOrder, TheNaiveSolverKnowsTheVelocitiesBeforeForcesAct) {
  WorldState world;
  world.settings.solver = SolverKind::Naive;
  world.bodies = bodies_of_kinds(2, 1);
  world.bodies[1].linear_velocity = {3, 0, 0};
  world.pairs = pairs_of(std::vector<Contact>{contact_between(0, 2, 1)});
  arrange_contacts(world);
  begin_constraints(world);
  prepare(world, contact_step(world.settings, Real(0.01)));
  ASSERT_EQ(world.constraints.size(), 1U);
  EXPECT_EQ(world.solver_bodies[1].v, Vec3(3, 0, 0));
}

}  // namespace
}  // namespace cs550::test
