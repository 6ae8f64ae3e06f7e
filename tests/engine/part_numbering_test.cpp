// The numbers of the bodies while several threads share a step: part by part, and again the old ones afterwards.
#include "engine/parts/part_numbering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/pairs_of_contacts.hpp"
#include "engine/parts/body_parts.hpp"

namespace cs550::test {
namespace {

constexpr Index body_count = 200;
const Vec3 down(0, 0, Real(-9.81));

/// A row of bodies that touch their neighbours, as a step with two threads has them once it has arranged its contacts.
/// The mass of a body is its place in the row.
struct Row {
  ThreadTeam team{2};
  WorldState world;

  Row() {
    std::vector<Contact> contacts;
    for (Index i = 0; i < body_count; ++i) {
      RigidBody& body = world.bodies.emplace_back();
      body.mass = static_cast<Real>(i);
      body.pose.position.x() = static_cast<Real>(i);
      if (i == 0) continue;
      Contact& contact = contacts.emplace_back();
      contact.body_a = i - 1;
      contact.body_b = i;
      contact.manifold.points.push_back({});
    }
    world.bodies[7].kind = BodyKind::Static;
    world.pairs = pairs_of(contacts);
    world.team = &team;
    world.solve_order.units.resize(3);
    world.solve_order.contacts = {0};
    divide();
  }

  void divide() { divide_bodies(world.pairs, world.bodies, down, world.parts); }

  /// The bodies have their own numbers.
  void expect_in_row() const {
    for (Index i = 0; i < body_count; ++i) EXPECT_EQ(world.bodies[i].mass, static_cast<Real>(i));
  }

  /// The bodies have those of their parts. @pre a PartNumbering lives
  void expect_part_by_part() const {
    const BodyParts& parts = world.parts;
    for (Index body = 0; body < body_count; ++body) {
      const Index number = parts.number_of(body);
      EXPECT_EQ(world.bodies[number].mass, static_cast<Real>(body));
      if (world.bodies[number].kind == BodyKind::Static) continue;
      const Index part = parts.of_body[body];
      EXPECT_GE(number, parts.first[part]) << "body " << body;
      EXPECT_LT(number, parts.first[part + 1]) << "body " << body;
    }
  }
};

TEST(PartNumbering, IsPartByPartWhileItLives) {
  Row row;
  ASSERT_EQ(row.world.parts.count, 2);
  {
    const PartNumbering numbering(row.world);
    ASSERT_TRUE(row.world.parts.renumbered);
    row.expect_part_by_part();
  }
  row.expect_in_row();
}

TEST(PartNumbering, FollowsTheNextDivision) {
  Row row;
  { const PartNumbering numbering(row.world); }
  const std::vector<Index> first_parts = row.world.parts.of_body;
  for (RigidBody& body : row.world.bodies) body.pose.position.x() *= -1;
  for (int step = 0; row.world.parts.of_body == first_parts; ++step) {
    ASSERT_LT(step, 100) << "the bodies keep their parts";
    row.divide();
  }
  const PartNumbering numbering(row.world);
  row.expect_part_by_part();
}

TEST(PartNumbering, HasRoomForBodiesThatAreAdded) {
  Row row;
  { const PartNumbering numbering(row.world); }
  row.world.bodies.emplace_back().mass = static_cast<Real>(body_count);
  row.divide();
  const PartNumbering numbering(row.world);
  row.expect_part_by_part();
  EXPECT_EQ(row.world.bodies[row.world.parts.number_of(body_count)].mass,
            static_cast<Real>(body_count));
}

TEST(PartNumbering, FollowsABodyThatComesFree) {
  Row row;
  { const PartNumbering numbering(row.world); }
  ASSERT_EQ(row.world.parts.of_body[7], 0) << "its number is one of the last part";
  row.world.bodies[7].kind = BodyKind::Dynamic;
  const PartNumbering numbering(row.world);
  row.expect_part_by_part();
}

}  // namespace
}  // namespace cs550::test
