#include <algorithm>
#include <cassert>
#include <tuple>
#include <utility>

#include "cs550/broad_phase.hpp"
#include "cs550/static_vector.hpp"

namespace cs550 {
namespace {

Bounds united(const Bounds& a, const Bounds& b) {
  Bounds result = a;
  result.include(b);
  return result;
}

bool are_equal(const Bounds& a, const Bounds& b) {
  return a.lower == b.lower && a.upper == b.upper;
}

/// Half the surface area: how likely a random ray meets the box, up to a factor.
Real area(const Bounds& bounds) {
  const Vec3 size = bounds.extent();
  return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
}

/// Whether the part of a ray between 0 and `length` meets a box (Kay & Kajiya's slabs).
bool ray_meets(const Bounds& bounds, const Vec3& origin, const Vec3& direction, Real length) {
  Real entry = 0;
  Real exit = length;
  for (int axis = 0; axis < 3; ++axis) {
    const Real lower = bounds.lower[axis] - origin[axis];
    const Real upper = bounds.upper[axis] - origin[axis];
    if (direction[axis] == 0) {
      if (lower > 0 || upper < 0) return false;
      continue;
    }
    const Real first = lower / direction[axis];
    const Real second = upper / direction[axis];
    entry = std::max(entry, std::min(first, second));
    exit = std::min(exit, std::max(first, second));
  }
  return entry <= exit;
}

/// Visits a tree depth first. The links to the parents lead back up, so a tree of any height needs
/// neither recursion nor a stack.
/// @param enter whether to look below a node: `bool enter(const Node&)`
/// @param first which of a node's children comes first, 0 or 1, always the same: `int first(const
/// Node&)`
template <class Enter, class First>
void walk(std::span<const AabbTree::Node> nodes, Index root, Enter enter, First first) {
  const auto at = [nodes](Index i) -> const AabbTree::Node& { return nodes[i]; };
  Index index = root;
  while (index != no_index) {
    const AabbTree::Node& node = at(index);
    if (enter(node) && !node.is_leaf()) {
      index = node.child[first(node)];
      continue;
    }
    Index parent = node.parent;
    while (parent != no_index && index != at(parent).child[first(at(parent))]) {
      index = parent;
      parent = at(index).parent;
    }
    index = parent == no_index ? no_index : at(parent).child[1 - first(at(parent))];
  }
}

}  // namespace

Index AabbTree::insert(const Bounds& bounds, Index user) {
  const Index leaf = take_node();
  node(leaf).bounds = bounds;
  node(leaf).user = user;
  attach(leaf);
  ++leaf_count_;
  return leaf;
}

void AabbTree::remove(Index leaf) {
  assert(node(leaf).height == 0);
  detach(leaf);
  free_node(leaf);
  --leaf_count_;
}

void AabbTree::move(Index leaf, const Bounds& bounds) {
  assert(node(leaf).height == 0);
  if (stays_in_place(leaf, bounds)) {
    node(leaf).bounds = bounds;
    refit_upwards(node(leaf).parent);
    return;
  }
  detach(leaf);
  node(leaf).bounds = bounds;
  attach(leaf);
}

const Bounds& AabbTree::bounds(Index leaf) const { return node(leaf).bounds; }

int AabbTree::height() const { return root_ == no_index ? 0 : node(root_).height; }

void AabbTree::query(const Bounds& bounds, std::vector<Index>& users) const {
  if (root_ == no_index || !node(root_).bounds.overlaps(bounds)) return;
  query_below(root_, bounds, users);
}

void AabbTree::ray_cast(const Vec3& origin, const Vec3& direction, Real length,
                        const std::function<Real(Index user, Real length)>& visit) const {
  const auto enter = [&](const Node& visited) {
    if (!ray_meets(visited.bounds, origin, direction, length)) return false;
    if (visited.is_leaf()) length = visit(visited.user, length);
    return true;
  };
  // The nearer child first: its hits shorten the ray before the farther one is looked at.
  const auto nearer = [&](const Node& visited) {
    const Vec3 apart =
        node(visited.child[1]).bounds.center() - node(visited.child[0]).bounds.center();
    return direction.dot(apart) < 0 ? 1 : 0;
  };
  walk(nodes_, root_, enter, nearer);
}

/// @pre the boxes overlap. A stack is faster than walk(), which returns to each node from below. If the stack
/// is full, another call continues with a stack of its own.
void AabbTree::query_below(Index top, const Bounds& bounds, std::vector<Index>& users) const {
  StaticVector<Index, 64> open;
  open.push_back(top);
  while (!open.empty()) {
    const Node& visited = node(open.back());
    open.shrink(open.size() - 1);
    if (visited.is_leaf()) {
      users.push_back(visited.user);
      continue;
    }
    for (const Index child : visited.child) {
      if (!node(child).bounds.overlaps(bounds)) continue;
      if (open.full()) {
        query_below(child, bounds, users);
      } else {
        open.push_back(child);
      }
    }
  }
}

/// Whether a leaf may keep its place. Reinserting it takes three times as long, but a tree degrades if its leaves
/// never change place: with 2,000 bodies that fly about, queries become twelve times slower. The tree stays as
/// good as a new one if the new box is inside that of the third node above the leaf.
bool AabbTree::stays_in_place(Index leaf, const Bounds& bounds) const {
  constexpr int levels = 3;
  Index above = leaf;
  for (int level = 0; level < levels && above != no_index; ++level) above = node(above).parent;
  return above != no_index && node(above).bounds.contains(bounds);
}

Index AabbTree::take_node() {
  if (free_ == no_index) {
    nodes_.emplace_back();
    return static_cast<Index>(nodes_.size()) - 1;
  }
  const Index taken = free_;
  free_ = node(taken).parent;
  node(taken) = Node{};
  return taken;
}

void AabbTree::free_node(Index index) {
  node(index) = Node{};
  node(index).height = -1;
  node(index).parent = free_;
  free_ = index;
}

/// Puts a leaf beside its best sibling, below a new node that takes the sibling's place.
void AabbTree::attach(Index leaf) {
  if (root_ == no_index) {
    root_ = leaf;
    node(leaf).parent = no_index;
    return;
  }
  const Index sibling = best_sibling(node(leaf).bounds);
  const Index joint = take_node();
  replace_child(node(sibling).parent, sibling, joint);
  node(joint).child[0] = sibling;
  node(joint).child[1] = leaf;
  node(sibling).parent = joint;
  node(leaf).parent = joint;
  refit_upwards(joint);
}

/// Takes a leaf out; its sibling takes the place of their parent, which is freed.
void AabbTree::detach(Index leaf) {
  const Index joint = node(leaf).parent;
  if (joint == no_index) {
    root_ = no_index;
    return;
  }
  const Index sibling = node(joint).child[node(joint).child[0] == leaf ? 1 : 0];
  const Index parent = node(joint).parent;
  replace_child(parent, joint, sibling);
  free_node(joint);
  refit_upwards(parent);
}

/// @param parent of the child, or no_index if the child is the root
void AabbTree::replace_child(Index parent, Index child, Index replacement) {
  node(replacement).parent = parent;
  if (parent == no_index) {
    root_ = replacement;
  } else {
    node(parent).child[node(parent).child[0] == child ? 0 : 1] = replacement;
  }
}

/// A node beside which a new leaf adds little area to the tree. Catto (2019) searches by the same
/// bounds, but all branches; this descends along one.
/// The cost of a place is the area of the joint that is made there, plus the growth of all nodes
/// above it.
Index AabbTree::best_sibling(const Bounds& bounds) const {
  const Real own_area = area(bounds);
  Index best = root_;
  Real best_cost = area(united(node(root_).bounds, bounds));
  Real inherited = 0;
  Index index = root_;
  while (!node(index).is_leaf()) {
    const Node& parent = node(index);
    inherited += area(united(parent.bounds, bounds)) - area(parent.bounds);

    // Equal costs are settled by distance, then by height: among boxes that coincide the tree stays
    // balanced.
    Index next = no_index;
    std::tuple<Real, Real, Index> least = {HUGE_VALF, HUGE_VALF, 0};
    for (const Index child : parent.child) {
      const Real joint_area = area(united(node(child).bounds, bounds));
      if (inherited + joint_area <= best_cost) {
        best = child;
        best_cost = inherited + joint_area;
      }
      // No place below the child costs less: it grows, and the joint holds at least the new leaf.
      const Real bound = inherited + joint_area - area(node(child).bounds) + own_area;
      const Real distance = (node(child).bounds.center() - bounds.center()).squaredNorm();
      const auto rank = std::make_tuple(bound, distance, node(child).height);
      if (rank < least) {
        next = child;
        least = rank;
      }
    }
    if (next == no_index || std::get<0>(least) > best_cost) break;
    index = next;
  }
  return best;
}

/// Ends below the first node that does not change.
void AabbTree::refit_upwards(Index index) {
  while (index != no_index) {
    const Node before = node(index);
    refit(index);
    rotate(index);
    const Node& now = node(index);
    if (are_equal(now.bounds, before.bounds) && now.height == before.height) return;
    index = now.parent;
  }
}

void AabbTree::refit(Index index) {
  Node& parent = node(index);
  const Node& first = node(parent.child[0]);
  const Node& second = node(parent.child[1]);
  parent.bounds = united(first.bounds, second.bounds);
  parent.height = 1 + std::max(first.height, second.height);
}

/// Swaps a child with a grandchild on the other side where that shrinks the tree (Kensler 2008):
/// in area, or in height where the area stays the same, as among boxes that coincide.
void AabbTree::rotate(Index index) {
  struct Swap {
    int side = -1;        ///< of the child that goes down
    int grandchild = -1;  ///< that comes up, of the child on the other side
    Real growth = 0;
    Index height = 0;
  };
  Swap best;
  best.height = node(index).height;
  for (int side = 0; side < 2; ++side) {
    const Node& down = node(node(index).child[side]);
    const Node& other = node(node(index).child[1 - side]);
    if (other.is_leaf()) continue;
    for (int grandchild = 0; grandchild < 2; ++grandchild) {
      const Node& up = node(other.child[grandchild]);
      const Node& stays = node(other.child[1 - grandchild]);
      const Real growth = area(united(down.bounds, stays.bounds)) - area(other.bounds);
      const Index height = 1 + std::max(up.height, 1 + std::max(down.height, stays.height));
      if (growth < best.growth || (growth == best.growth && height < best.height)) {
        best = {side, grandchild, growth, height};
      }
    }
  }
  if (best.side < 0) return;

  const Index down = node(index).child[best.side];
  const Index other = node(index).child[1 - best.side];
  const Index up = node(other).child[best.grandchild];
  std::swap(node(index).child[best.side], node(other).child[best.grandchild]);
  node(up).parent = index;
  node(down).parent = other;
  refit(other);
  refit(index);
}

}  // namespace cs550
