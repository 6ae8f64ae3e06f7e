#pragma once
/// @file broad_phase.hpp
/// The broad phase: a dynamic tree of axis-aligned boxes that finds bodies near each other.

#include <functional>
#include <span>
#include <vector>

#include "cs550/math.hpp"

namespace cs550 {

/// A binary bounding volume hierarchy that is updated incrementally. A new leaf is inserted where
/// the total surface area grows least, and rotations keep the tree shallow (Catto, *Dynamic
/// Bounding Volume Hierarchies*, GDC 2019). A leaf that moves a little keeps its place.
/// Leaves store fat AABBs, so that most steps leave the tree unchanged. A plain value: a copy
/// continues identically.
class AabbTree {
 public:
  /// Adds a leaf.
  /// @param bounds the fat AABB: the caller has already added its margin
  /// @param user the value that queries report for this leaf
  /// @return the handle of the leaf, valid until it is removed
  Index insert(const Bounds& bounds, Index user);
  /// Precondition: `leaf` is in the tree.
  void remove(Index leaf);
  /// Replaces the box of a leaf. Precondition: `leaf` is in the tree.
  void move(Index leaf, const Bounds& bounds);
  /// The current box of a leaf. Precondition: `leaf` is in the tree.
  const Bounds& bounds(Index leaf) const;

  /// Appends the users of all leaves that overlap a box, in no particular order.
  void query(const Bounds& bounds, std::vector<Index>& users) const;

  /// Visits the leaves that a ray intersects. The visitor receives a user and the current length of
  /// the ray and returns the new length: shorter after a hit, unchanged after a miss.
  /// @param origin world frame (m)
  /// @param direction world frame, unit
  /// @param length m
  void ray_cast(const Vec3& origin, const Vec3& direction, Real length,
                const std::function<Real(Index user, Real length)>& visit) const;

  /// The number of leaves.
  int leaf_count() const { return leaf_count_; }
  /// The number of levels below the root; 0 for a tree of one leaf or none.
  int height() const;

  /// A node, exposed for drawing the tree. Only leaves have a user.
  struct Node {
    Bounds bounds;                          ///< encloses all leaves below
    Index parent = no_index;                ///< in a free node: the next free node
    Index child[2] = {no_index, no_index};  ///< none or two
    Index user = no_index;                  ///< as passed to insert(); no_index in inner nodes
    Index height = 0;                       ///< 0 for leaves, −1 for free nodes

    /// Whether the node has no children.
    bool is_leaf() const { return child[0] == no_index; }
  };
  /// The node array, including free nodes.
  std::span<const Node> nodes() const { return nodes_; }
  /// The index of the root in nodes(); no_index for an empty tree.
  Index root() const { return root_; }

 private:
  Node& node(Index index) { return nodes_[static_cast<std::size_t>(index)]; }
  const Node& node(Index index) const { return nodes_[static_cast<std::size_t>(index)]; }

  Index take_node();
  void free_node(Index index);
  void attach(Index leaf);
  void detach(Index leaf);
  void replace_child(Index parent, Index child, Index replacement);
  void query_below(Index top, const Bounds& bounds, std::vector<Index>& users) const;
  bool stays_in_place(Index leaf, const Bounds& bounds) const;
  Index best_sibling(const Bounds& bounds) const;
  void refit_upwards(Index index);
  void refit(Index index);
  void rotate(Index index);

  std::vector<Node> nodes_;
  Index root_ = no_index;
  Index free_ = no_index;
  int leaf_count_ = 0;
};

}  // namespace cs550
