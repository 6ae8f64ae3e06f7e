// Rows of contacts that are solved from the middle of the world outwards.
#include "engine/contacts/row_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/contacts/solve_order.hpp"
#include "engine/pairs_of_contacts.hpp"
#include "engine/parts/body_parts.hpp"

namespace cs550::test {
namespace {

const Vec3 down(0, Real(-9.81), 0);

/// A pyramid of bricks, each of which rests on two of the row below. Bricks of a row do not touch. The contacts are
/// sorted by body A, then by body B, as the world sorts them.
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

 private:
  void touch(Index a, Index b) {
    Contact& contact = contacts.emplace_back();
    contact.body_a = a;
    contact.body_b = b;
    contact.manifold.normal = Vec3::UnitY();
    contact.manifold.points.push_back({});
  }
};

struct Order {
  BodyParts parts;
  SolveOrder order;

  explicit Order(const Pyramid& pyramid) {
    const PairList pairs = pairs_of(pyramid.contacts);
    divide_bodies(pairs, pyramid.bodies, down, parts);
    ThreadTeam team(2);
    arrange_constraints(pairs, pyramid.bodies, down, order, parts, &team);
  }
};

TEST(RowOrder, OfAPyramidIsFromTheMiddleOutwards) {
  for (const bool from_the_left : {true, false}) {
    SCOPED_TRACE(from_the_left ? "numbered from the left" : "numbered from the right");
    const Pyramid pyramid(20, from_the_left);
    const Order now(pyramid);
    ASSERT_EQ(now.parts.count, 2);
    EXPECT_EQ(now.parts.direction, Vec3(Vec3::UnitX()));
    for (const Index part : {0, 1}) {
      const SolveUnit& unit = now.order.units[part];
      const Real outwards = part == 0 ? Real(-1) : Real(1);
      ASSERT_GT(unit.end_contact - unit.first_contact, 100);
      for (Index i = unit.first_contact + 1; i < unit.end_contact; ++i) {
        const Contact& last = pyramid.contacts[now.order.contacts[i - 1]];
        const Contact& next = pyramid.contacts[now.order.contacts[i]];
        ASSERT_LE(pyramid.row_of(last), pyramid.row_of(next)) << "rows from the bottom to the top";
        const bool next_row = pyramid.row_of(last) < pyramid.row_of(next);
        const bool two_contacts =
            pyramid.row_of(next) > pyramid.rows - 5;  // or fewer are not a row
        if (next_row || two_contacts) continue;
        const Real x = pyramid.bodies[last.body_a].pose.position.x();
        const Real next_x = pyramid.bodies[next.body_a].pose.position.x();
        EXPECT_LE(outwards * x, outwards * next_x) << "part " << part << ", contact " << i;
      }
    }
  }
}

// In the order of the bodies the side where the numbers begin at the slope needs 53 groups of eight, the other 36.
TEST(RowOrder, NeitherSideOfAPyramidNeedsAFifthMoreGroups) {
  for (const bool from_the_left : {true, false}) {
    const Pyramid pyramid(20, from_the_left);
    const Order now(pyramid);
    const std::size_t left = now.order.units[0].groups.size();
    const std::size_t right = now.order.units[1].groups.size();
    EXPECT_LE(5 * std::max(left, right), 6 * std::min(left, right))
        << left << " and " << right << ", numbered from the left: " << from_the_left;
  }
}

TEST(RowOrder, LeavesAWorldOfOnePart) {
  const Pyramid pyramid(8, false);
  const Order now(pyramid);
  ASSERT_EQ(now.parts.count, 1);
  EXPECT_TRUE(std::is_sorted(now.order.contacts.begin(), now.order.contacts.end()));
}

}  // namespace
}  // namespace cs550::test
