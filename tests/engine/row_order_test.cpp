// Rows of contacts that are solved from the middle of the world outwards.
#include "engine/contacts/row_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "engine/contacts/solve_order.hpp"
#include "engine/pairs_of_contacts.hpp"
#include "engine/parts/body_parts.hpp"

namespace cs550::test {
namespace {

const Vec3 down(0, Real(-9.81), 0);

Contact contact_between(Index a, Index b, const Vec3& normal) {
  Contact contact;
  contact.body_a = a;
  contact.body_b = b;
  contact.manifold.normal = normal;
  contact.manifold.points.push_back({});
  return contact;
}

/// A pyramid in which each brick rests on two bricks of the row below and touches no neighbour in its own row. Contacts
/// are sorted by body A, then by body B, as in a world.
struct Pyramid {
  int rows;
  std::vector<RigidBody> bodies;
  std::vector<Contact> contacts;

  /// @param from_the_left whether the bricks of a row are numbered from the lowest x, or from the highest
  Pyramid(int row_count, bool from_the_left) : rows(row_count) {
    Index row_begin = 0;
    for (int row = 0; row < rows; ++row) {
      const int bricks = rows - row;
      for (int i = 0; i < bricks; ++i) {
        const Real x = static_cast<Real>(i) - Real(0.5) * static_cast<Real>(bricks - 1);
        bodies.emplace_back().pose.position =
            Vec3(from_the_left ? x : -x, static_cast<Real>(row), 0);
        const Index brick = row_begin + i;
        if (i > 0 && row + 1 < rows) touch(brick, brick + bricks - 1);
        if (i + 1 < bricks) touch(brick, brick + bricks);
      }
      row_begin += bricks;
    }
  }

  int row_of(const Contact& contact) const {
    return static_cast<int>(bodies[contact.body_a].pose.position.y());
  }
  Real x_of(const Contact& contact) const {
    return bodies[contact.body_a].pose.position.x() + bodies[contact.body_b].pose.position.x();
  }

 private:
  void touch(Index a, Index b) { contacts.push_back(contact_between(a, b, Vec3::UnitY())); }
};

/// The contacts in the order in which they are solved.
SolveOrder arrange(const std::vector<RigidBody>& bodies, const std::vector<Contact>& contacts,
                   const BodyParts& parts) {
  ThreadTeam team(2);
  SolveOrder order;
  arrange_constraints(pairs_of(contacts), bodies, down, order, parts, &team);
  return order;
}

BodyParts divide(const Pyramid& pyramid) {
  BodyParts parts;
  divide_bodies(pairs_of(pyramid.contacts), pyramid.bodies, down, parts);
  return parts;
}

/// Parts of equal width across x.
BodyParts parts_of_equal_width(const Pyramid& pyramid, Index count) {
  BodyParts parts;
  parts.count = count;
  parts.direction = Vec3::UnitX();
  const Real width = static_cast<Real>(pyramid.rows);
  for (const RigidBody& body : pyramid.bodies) {
    const Real share = body.pose.position.x() / width + Real(0.5);
    parts.of_body.push_back(
        std::min(static_cast<Index>(share * static_cast<Real>(count)), count - 1));
  }
  return parts;
}

void expect_rows_outwards(const Pyramid& pyramid, const BodyParts& parts) {
  const SolveOrder order = arrange(pyramid.bodies, pyramid.contacts, parts);
  for (Index part = 0; part < parts.count; ++part) {
    SCOPED_TRACE("part " + std::to_string(part));
    const SolveUnit& unit = order.units[part];
    const Real outwards = part < parts.count / 2 ? Real(-1) : Real(1);
    std::vector<std::vector<Real>> rows(pyramid.rows);
    int last_row = 0;
    for (Index i = unit.first_contact; i < unit.end_contact; ++i) {
      const Contact& contact = pyramid.contacts[order.contacts[i]];
      const int row = pyramid.row_of(contact);
      EXPECT_GE(row, last_row) << "from the bottom to the top";
      last_row = row;
      rows[row].push_back(outwards * pyramid.x_of(contact));
    }
    EXPECT_GE(rows[0].size(), 3U);
    for (const std::vector<Real>& row : rows) {
      if (row.size() < 3) continue;
      EXPECT_TRUE(std::is_sorted(row.begin(), row.end()));
    }
  }
}

TEST(RowOrder, OfAPyramidIsFromTheMiddleOutwards) {
  for (const bool from_the_left : {true, false}) {
    SCOPED_TRACE(from_the_left ? "numbered from the left" : "numbered from the right");
    const Pyramid pyramid(20, from_the_left);
    const BodyParts parts = divide(pyramid);
    ASSERT_EQ(parts.count, 2);
    EXPECT_EQ(parts.direction, Vec3(Vec3::UnitX()));
    expect_rows_outwards(pyramid, parts);
    expect_rows_outwards(pyramid, parts_of_equal_width(pyramid, 4));
  }
}

// In the order of the bodies the side where the numbers begin at the slope needs 53 groups of eight, the other 36.
TEST(RowOrder, NeitherSideOfAPyramidNeedsAFifthMoreGroups) {
  for (const bool from_the_left : {true, false}) {
    const Pyramid pyramid(20, from_the_left);
    const SolveOrder order = arrange(pyramid.bodies, pyramid.contacts, divide(pyramid));
    const std::size_t left = order.units[0].groups.size();
    const std::size_t right = order.units[1].groups.size();
    EXPECT_LE(std::max(left, right), 43U) << "numbered from the left: " << from_the_left;
    EXPECT_LE(5 * std::max(left, right), 6 * std::min(left, right));
  }
}

TEST(RowOrder, LeavesAWorldOfOnePart) {
  const Pyramid pyramid(8, false);
  BodyParts parts = divide(pyramid);
  ASSERT_EQ(parts.count, 1);
  parts.direction = Vec3::UnitX();  // of earlier parts
  const SolveOrder order = arrange(pyramid.bodies, pyramid.contacts, parts);
  EXPECT_TRUE(std::is_sorted(order.contacts.begin(), order.contacts.end()));
}

std::vector<std::vector<Index>> groups_of(const SolveOrder& order) {
  std::vector<std::vector<Index>> groups;
  for (const SolveUnit& unit : order.units) {
    for (const ContactGroup& group : unit.groups) groups.emplace_back(group.begin(), group.end());
  }
  return groups;
}

// Rows keep their direction from step to step, but not longer than the world gives a reason for it. Else a world that
// was saved and restored would continue in another order.
TEST(RowOrder, OfAWorldThatMovesIsThatOfAFreshWorld) {
  ThreadTeam team(2);
  Pyramid pyramid(20, true);
  BodyParts parts = divide(pyramid);
  SolveOrder used;
  std::vector<std::vector<Index>> orders;
  const auto expect_fresh = [&](const char* what, ThreadTeam* present_team) {
    SCOPED_TRACE(what);
    const PairList pairs = pairs_of(pyramid.contacts);
    SolveOrder fresh;
    arrange_constraints(pairs, pyramid.bodies, down, fresh, parts, present_team);
    arrange_constraints(pairs, pyramid.bodies, down, used, parts, present_team);
    EXPECT_EQ(used.contacts, fresh.contacts);
    EXPECT_EQ(used.place_of_point, fresh.place_of_point);
    EXPECT_EQ(groups_of(used), groups_of(fresh));
    orders.push_back(fresh.contacts);
  };
  const auto scale_x = [&](Real factor) {
    for (RigidBody& body : pyramid.bodies) body.pose.position.x() *= factor;
  };
  const auto expect_fresh_in_all_positions = [&](ThreadTeam* present_team) {
    orders.clear();
    expect_fresh("as it was divided", present_team);
    expect_fresh("the same", present_team);
    scale_x(-1);
    expect_fresh("mirrored", present_team);
    const std::vector<RigidBody> mirrored = pyramid.bodies;
    scale_x(0);
    expect_fresh("each row at one place", present_team);
    pyramid.bodies = mirrored;
    parts.direction = -parts.direction;
    expect_fresh("with the opposite direction", present_team);
    parts.direction = -parts.direction;
    expect_fresh("mirrored again", present_team);
    scale_x(-1);
  };
  for (ThreadTeam* present_team : {&team, static_cast<ThreadTeam*>(nullptr), &team}) {
    expect_fresh_in_all_positions(present_team);
    EXPECT_EQ(orders[1], orders[0]);
    EXPECT_NE(orders[2], orders[0]);
    EXPECT_NE(orders[3], orders[2]) << "the example turns rows back";
    EXPECT_EQ(orders[4], orders[0]);
    EXPECT_EQ(orders[5], orders[2]);
  }
}

/// Four bricks of a row, at x = 0, −1, −2, −3, and four of the next row, at −0.5, −1.5, …, in the last of two parts,
/// where outwards is towards higher x.
struct Bricks {
  std::vector<RigidBody> bodies{8};
  BodyParts parts;
  std::vector<Contact> contacts;

  Bricks() {
    parts.count = 2;
    parts.direction = Vec3::UnitX();
    parts.of_body.assign(bodies.size(), 1);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Real shift = i < 4 ? Real(0) : Real(0.5);
      bodies[i].pose.position.x() = -static_cast<Real>(i % 4) - shift;
    }
  }
  void touch(Index a, Index b, const Vec3& normal = Vec3::UnitY()) {
    contacts.push_back(contact_between(a, b, normal));
  }
  std::vector<Index> order() const { return arrange(bodies, contacts, parts).contacts; }
};

// All contacts are in the first of two parts, and then the world is no longer divided: one thread has them as one unit
// both times.
TEST(RowOrder, OfAWorldThatIsNoLongerDividedIsThatOfAFreshWorld) {
  const Pyramid pyramid(20, false);
  BodyParts parts;
  parts.count = 2;
  parts.direction = Vec3::UnitX();
  parts.of_body.assign(pyramid.bodies.size(), 0);
  SolveOrder used;
  arrange_constraints(pairs_of(pyramid.contacts), pyramid.bodies, down, used, parts);
  parts.count = 1;
  arrange_constraints(pairs_of(pyramid.contacts), pyramid.bodies, down, used, parts);
  SolveOrder fresh;
  arrange_constraints(pairs_of(pyramid.contacts), pyramid.bodies, down, fresh, parts);
  EXPECT_EQ(used.contacts, fresh.contacts);
}

TEST(RowOrder, TurnsNoContactsOfOneBody) {
  Bricks bricks;
  for (const Index b : {4, 5, 6}) bricks.touch(0, b);
  bricks.touch(1, 6);
  EXPECT_EQ(bricks.order(), (std::vector<Index>{0, 1, 2, 3})) << "they are no zigzag";
}

TEST(RowOrder, TurnsThreeContactsButNotTwo) {
  Bricks bricks;
  bricks.touch(0, 4);
  bricks.touch(1, 4);
  EXPECT_EQ(bricks.order(), (std::vector<Index>{0, 1}));
  bricks.touch(1, 5);
  EXPECT_EQ(bricks.order(), (std::vector<Index>{2, 1, 0}));
}

TEST(RowOrder, LeavesContactsOfNeighboursLast) {
  Bricks bricks;
  bricks.touch(0, 4);
  bricks.touch(1, 4);
  bricks.touch(1, 5);
  bricks.touch(2, 5, Vec3::UnitX());  // would continue the zigzag
  EXPECT_EQ(bricks.order(), (std::vector<Index>{2, 1, 0, 3}));
}

TEST(RowOrder, IgnoresImmovableBodies) {
  Bricks bricks;
  bricks.bodies[0].kind = BodyKind::Static;
  bricks.touch(0, 4);
  bricks.touch(0, 5);
  bricks.touch(1, 5);
  EXPECT_EQ(bricks.order(), (std::vector<Index>{0, 1, 2})) << "the floor ties none to another";
}

}  // namespace
}  // namespace cs550::test
