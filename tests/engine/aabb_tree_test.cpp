// The tree against brute force: after any insertions, moves and removals, its queries give the same
// results as a search through all boxes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "cs550/broad_phase.hpp"
#include "helpers/random.hpp"

namespace cs550 {
namespace {

using test::Random;

Bounds random_bounds(Random& random, Real world, Real largest) {
  const Vec3 center = random.point_in_box(Vec3::Constant(world));
  const Vec3 half = random.point_in_box(Vec3::Constant(largest)).cwiseAbs();
  return {center - half, center + half};
}

/// The distance at which a ray enters a box, in double precision, or a negative number for a miss.
double entry_distance(const Bounds& bounds, const Vec3& origin, const Vec3& direction) {
  double entry = 0;
  double exit = HUGE_VAL;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = static_cast<double>(direction[axis]);
    const double first = (static_cast<double>(bounds.lower[axis]) - origin[axis]) / d;
    const double second = (static_cast<double>(bounds.upper[axis]) - origin[axis]) / d;
    entry = std::max(entry, std::min(first, second));
    exit = std::min(exit, std::max(first, second));
  }
  return entry <= exit ? entry : -1;
}

std::vector<Index> query_sorted(const AabbTree& tree, const Bounds& bounds) {
  std::vector<Index> users;
  tree.query(bounds, users);
  std::sort(users.begin(), users.end());
  return users;
}

/// The tree under test and a list of the same boxes.
struct ListAndTree {
  AabbTree tree;
  std::map<Index, Bounds> boxes;  // by user
  std::map<Index, Index> leaves;  // user to leaf
  Index next_user = 0;

  void insert(const Bounds& bounds) {
    leaves[next_user] = tree.insert(bounds, next_user);
    boxes[next_user] = bounds;
    ++next_user;
  }
  Index random_user(Random& random) const {
    return std::next(boxes.begin(), random.integer(0, static_cast<int>(boxes.size()) - 1))->first;
  }
  void move(Index user, const Bounds& bounds) {
    tree.move(leaves.at(user), bounds);
    boxes[user] = bounds;
  }
  void remove(Index user) {
    tree.remove(leaves.at(user));
    leaves.erase(user);
    boxes.erase(user);
  }
  std::vector<Index> search(const Bounds& bounds) const {
    std::vector<Index> users;
    for (const auto& [user, box] : boxes) {
      if (box.overlaps(bounds)) users.push_back(user);
    }
    return users;
  }
};

/// Checks links, boxes and heights of all nodes below the root.
void expect_sound(const AabbTree& tree) {
  const auto nodes = tree.nodes();
  const auto at = [nodes](Index i) { return nodes[i]; };
  int leaves = 0;
  std::vector<Index> below;
  if (tree.root() != no_index) {
    below.push_back(tree.root());
    ASSERT_EQ(at(tree.root()).parent, no_index);
  }
  while (!below.empty()) {
    const Index index = below.back();
    below.pop_back();
    const AabbTree::Node node = at(index);
    if (node.is_leaf()) {
      ++leaves;
      ASSERT_EQ(node.height, 0);
      continue;
    }
    Index tallest = 0;
    for (const Index child : node.child) {
      ASSERT_EQ(at(child).parent, index);
      ASSERT_TRUE(node.bounds.contains(at(child).bounds)) << "node " << index;
      tallest = std::max(tallest, at(child).height);
      below.push_back(child);
    }
    ASSERT_EQ(node.height, 1 + tallest);
  }
  ASSERT_EQ(leaves, tree.leaf_count());
}

TEST(AabbTree, FindsWhatASearchThroughAllBoxesFinds) {
  for (const std::uint32_t seed : {1U, 2U, 3U, 4U}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    ListAndTree both;
    std::size_t found = 0;
    for (int operation = 0; operation < 5000; ++operation) {
      const int kind = random.integer(0, 9);
      if (kind < 3 || both.boxes.empty()) {
        both.insert(random_bounds(random, 20, 2));
      } else if (kind < 6) {
        both.move(both.random_user(random), random_bounds(random, 20, 2));
      } else if (kind < 8) {
        both.remove(both.random_user(random));
      } else {
        const Bounds region = random_bounds(random, 20, 6);
        const std::vector<Index> expected = both.search(region);
        found += expected.size();
        ASSERT_EQ(query_sorted(both.tree, region), expected) << "operation " << operation;
      }
      if (operation % 97 == 0) expect_sound(both.tree);
    }
    expect_sound(both.tree);
    EXPECT_GT(found, 1000U) << "the queries hardly met a box";
  }
}

/// Of all inner nodes, relative to that of the root: how many of them a query meets on average.
double relative_area(const AabbTree& tree) {
  const auto area = [](const Bounds& bounds) {
    const Eigen::Vector3d size = bounds.extent().cast<double>();
    return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
  };
  double sum = 0;
  for (const AabbTree::Node& node : tree.nodes()) {
    if (node.height > 0) sum += area(node.bounds);
  }
  return sum / area(tree.nodes()[tree.root()].bounds);
}

// Leaves that keep their place for too long make a tree six times as large here.
TEST(AabbTree, StaysAsGoodAsANewOneWhileItsBoxesFlyAbout) {
  constexpr Real wall = 10;
  constexpr int count = 2000;
  Random random(7);
  std::vector<Vec3> centers;
  std::vector<Vec3> steps;
  for (int i = 0; i < count; ++i) {
    centers.push_back(random.point_in_box(Vec3::Constant(wall)));
    steps.push_back(Real(0.05) * random.unit_vector());
  }
  const auto box = [&](int i) {
    return Bounds{centers[i] - Vec3::Constant(0.5), centers[i] + Vec3::Constant(0.5)};
  };
  ListAndTree both;
  for (int i = 0; i < count; ++i) both.insert(box(i));
  for (int step = 0; step < 400; ++step) {
    for (int i = 0; i < count; ++i) {
      centers[i] += steps[i];
      for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(centers[i][axis]) > wall) {
          steps[i][axis] = std::copysign(steps[i][axis], -centers[i][axis]);
        }
      }
      both.move(i, box(i));
    }
  }
  expect_sound(both.tree);
  AabbTree fresh;
  for (int i = 0; i < count; ++i) fresh.insert(box(i), i);
  // Insertion in another order changes the area by a tenth.
  EXPECT_LT(relative_area(both.tree), 1.1 * relative_area(fresh));
  const Bounds region{Vec3::Constant(-3), Vec3::Constant(2)};
  EXPECT_EQ(query_sorted(both.tree, region), both.search(region));
}

// Boxes of twice the size each, side by side, make a tree of one long branch.
TEST(AabbTree, QueriesATreeThatIsHigherThanTheirStack) {
  for (const bool from_the_largest : {false, true}) {
    ListAndTree both;
    for (int i = 0; i <= 120; ++i) {
      const int power = from_the_largest ? 60 - i : i - 60;
      const Real size = std::ldexp(Real(1), power);
      both.insert({Vec3::Constant(size), Vec3::Constant(Real(1.5) * size)});
    }
    EXPECT_GT(both.tree.height(), 64);
    const Bounds everything{Vec3::Zero(), Vec3::Constant(std::ldexp(Real(1), 62))};
    EXPECT_EQ(query_sorted(both.tree, everything).size(), 121U);
  }
}

TEST(AabbTree, ShrinksToNothingAndGrowsAgain) {
  ListAndTree both;
  Random random(5);
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 50; ++i) both.insert(random_bounds(random, 5, 1));
    while (!both.boxes.empty()) both.remove(both.random_user(random));
    EXPECT_EQ(both.tree.leaf_count(), 0);
    EXPECT_EQ(both.tree.root(), no_index);
    EXPECT_TRUE(query_sorted(both.tree, {Vec3::Constant(-100), Vec3::Constant(100)}).empty());
  }
  EXPECT_LE(both.tree.nodes().size(), 99U) << "freed nodes are not used again";
}

TEST(AabbTree, RayMeetsTheNearestBoxOfAll) {
  Random random(6);
  ListAndTree both;
  for (int i = 0; i < 400; ++i) both.insert(random_bounds(random, 20, 2));
  int hits = 0;
  std::size_t visits = 0;
  for (int ray = 0; ray < 2000; ++ray) {
    const Vec3 origin = random.point_in_box(Vec3::Constant(30));
    const Vec3 direction = random.unit_vector();
    const Real length = random.real(5, 80);

    double expected = length;
    for (const auto& [user, box] : both.boxes) {
      const double distance = entry_distance(box, origin, direction);
      if (distance >= 0) expected = std::min(expected, distance);
    }
    double nearest = length;
    both.tree.ray_cast(origin, direction, length, [&](Index user, Real present) {
      ++visits;
      const double distance = entry_distance(both.boxes.at(user), origin, direction);
      if (distance < 0 || distance >= nearest) return present;
      nearest = distance;
      return static_cast<Real>(distance);
    });
    // The tree compares in float: 1e-5 of the largest coordinate.
    ASSERT_NEAR(nearest, expected, 1e-5 * 60) << "ray " << ray;
    hits += expected < length ? 1 : 0;
  }
  EXPECT_GT(hits, 300);
  EXPECT_LT(visits, 2000U * 20U)
      << "the ray is not shortened, or the nearer child does not come first";
}

TEST(AabbTree, RayAlongAnAxisAndOnAFace) {
  AabbTree tree;
  tree.insert({Vec3(1, -1, -1), Vec3(2, 1, 1)}, 7);
  const auto met = [&tree](const Vec3& origin, const Vec3& direction, Real length) {
    bool visited = false;
    tree.ray_cast(origin, direction, length, [&visited](Index, Real present) {
      visited = true;
      return present;
    });
    return visited;
  };
  EXPECT_TRUE(met(Vec3(0, 0, 0), Vec3::UnitX(), 5));
  EXPECT_TRUE(met(Vec3(0, 1, 0), Vec3::UnitX(), 5)) << "in the plane of a face";
  EXPECT_TRUE(met(Vec3(1.5F, 0, 0), Vec3::UnitY(), 5)) << "from inside";
  EXPECT_FALSE(met(Vec3(0, 0, 0), -Vec3::UnitX(), 5)) << "behind the origin";
  EXPECT_FALSE(met(Vec3(0, 0, 0), Vec3::UnitX(), 0.5F)) << "too short";
  EXPECT_FALSE(met(Vec3(0, 2, 0), Vec3::UnitX(), 5)) << "beside the box";
}

TEST(AabbTree, StaysShallowWhateverTheOrderOfInsertion) {
  // A perfect tree of n leaves has log2(n) levels. Queries are cheap up to a few times that.
  constexpr int count = 1024;
  constexpr int bound = 3 * 10;
  Random random(7);
  AabbTree scattered, row, stack_of_twins;
  for (Index i = 0; i < count; ++i) {
    scattered.insert(random_bounds(random, 50, 1), i);
    const Vec3 corner(static_cast<Real>(i), 0, 0);
    row.insert({corner, corner + Vec3::Ones()}, i);
    stack_of_twins.insert({Vec3::Zero(), Vec3::Ones()}, i);
  }
  EXPECT_LE(scattered.height(), bound) << "scattered boxes";
  EXPECT_LE(row.height(), bound) << "boxes in a row, in order";
  EXPECT_LE(stack_of_twins.height(), bound) << "the same box over and over";

  for (int lap = 0; lap < 20; ++lap) {
    for (Index leaf = 0; leaf < static_cast<Index>(scattered.nodes().size()); ++leaf) {
      if (scattered.nodes()[leaf].height != 0) continue;
      scattered.move(leaf, random_bounds(random, 50, 1));
    }
  }
  EXPECT_LE(scattered.height(), bound) << "after 20 moves of every box";
}

TEST(AabbTree, LooksAtFewBoxesForASmallQuery) {
  // The area of all inner nodes over that of the root: the expected number of nodes that a point
  // query inside the root visits. A useless tree would have 1,023.
  Random random(8);
  AabbTree tree;
  for (Index i = 0; i < 1024; ++i) tree.insert(random_bounds(random, 50, 1), i);
  const auto area = [](const Bounds& bounds) {
    const Vec3 size = bounds.extent();
    return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
  };
  Real sum = 0;
  for (const AabbTree::Node& node : tree.nodes()) {
    if (node.height > 0) sum += area(node.bounds);
  }
  EXPECT_LT(sum / area(tree.nodes()[tree.root()].bounds), 30);
}

TEST(AabbTree, CopyContinuesIdentically) {
  Random random(9);
  ListAndTree original;
  for (int i = 0; i < 100; ++i) original.insert(random_bounds(random, 10, 1));
  for (int i = 0; i < 30; ++i) original.remove(original.random_user(random));
  ListAndTree copy = original;

  for (int i = 0; i < 200; ++i) {
    const Bounds inserted = random_bounds(random, 10, 1);
    const Bounds moved = random_bounds(random, 10, 1);
    const Index user = original.random_user(random);
    for (ListAndTree* each : {&original, &copy}) {
      each->insert(inserted);
      each->move(user, moved);
    }
    ASSERT_EQ(original.leaves, copy.leaves);
  }
  std::vector<Index> of_original, of_copy;  // unsorted: the same order too
  original.tree.query({Vec3::Constant(-5), Vec3::Constant(5)}, of_original);
  copy.tree.query({Vec3::Constant(-5), Vec3::Constant(5)}, of_copy);
  EXPECT_EQ(of_original, of_copy);
  EXPECT_GT(of_original.size(), 10U);
}

TEST(AabbTree, MovingNeedsNoNewNodes) {
  Random random(10);
  ListAndTree both;
  for (int i = 0; i < 100; ++i) both.insert(random_bounds(random, 10, 1));
  const auto* nodes = both.tree.nodes().data();
  const std::size_t count = both.tree.nodes().size();
  for (int i = 0; i < 1000; ++i) both.move(both.random_user(random), random_bounds(random, 10, 1));
  EXPECT_EQ(both.tree.nodes().data(), nodes);
  EXPECT_EQ(both.tree.nodes().size(), count);
}

}  // namespace
}  // namespace cs550
