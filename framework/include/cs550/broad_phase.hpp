#pragma once
/// @file broad_phase.hpp
/// Which bodies are near each other: a dynamic tree of axis-aligned boxes.

#include <functional>
#include <span>
#include <vector>

#include "cs550/math.hpp"

namespace cs550 {

/// A binary tree of boxes, built and mended one leaf at a time: a new leaf goes where the summed
/// surface area grows least, and rotations keep the tree shallow (Catto, *Dynamic Bounding Volume
/// Hierarchies*, GDC 2019). Leaves hold boxes with room to move, so that most steps change nothing.
/// A plain value: a copy continues identically.
class AabbTree {
 public:
  /// Adds a leaf. @param bounds with the room already added, @param user what queries report
  /// @return the leaf's name until it is removed
  Index insert(const Bounds& bounds, Index user);
  /// Precondition: `leaf` is in the tree.
  void remove(Index leaf);
  /// Gives a leaf a new box. Precondition: `leaf` is in the tree.
  void move(Index leaf, const Bounds& bounds);
  /// The box that a leaf was given last.
  const Bounds& bounds(Index leaf) const;

  /// Appends the users of all leaves whose boxes overlap the given one, in no particular order.
  void query(const Bounds& bounds, std::vector<Index>& users) const;

  /// Visits leaves whose boxes a ray meets. The visitor gets a user and the present length of the
  /// ray and returns the new one: shorter after a hit, the same after a miss.
  /// @param origin, direction world frame, the direction unit; @param length m
  void ray_cast(const Vec3& origin, const Vec3& direction, Real length,
                const std::function<Real(Index user, Real length)>& visit) const;

  /// How many leaves there are.
  int leaf_count() const { return leaf_count_; }
  /// Levels below the root; 0 for one leaf or none.
  int height() const;

  /// One node for people who draw the tree; the leaves have a user.
  struct Node {
    Bounds bounds;                          ///< of all leaves below
    Index parent = no_index;                ///< also links the free nodes
    Index child[2] = {no_index, no_index};  ///< none or two
    Index user = no_index;                  ///< what insert() was told; no_index above the leaves
    Index height = 0;                       ///< leaves 0, free nodes −1

    /// Whether it has a user and no children.
    bool is_leaf() const { return child[0] == no_index; }
  };
  /// All places of nodes, the free ones included.
  std::span<const Node> nodes() const { return nodes_; }
  /// Where to begin in nodes(); no_index for an empty tree.
  Index root() const { return root_; }

 private:
  Node& node(Index index) { return nodes_[static_cast<std::size_t>(index)]; }
  const Node& node(Index index) const { return nodes_[static_cast<std::size_t>(index)]; }

  Index take_node();
  void free_node(Index index);
  void attach(Index leaf);
  void detach(Index leaf);
  void replace_child(Index parent, Index child, Index replacement);
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
