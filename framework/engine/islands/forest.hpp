#pragma once
/// @file forest.hpp
/// Union-find over bodies: each body has a parent, and a root is its own.

#include <algorithm>
#include <numeric>
#include <vector>

#include "cs550/math.hpp"

namespace cs550 {

/// Makes every body a tree of its own.
inline void plant_forest(std::vector<Index>& parent, std::size_t bodies) {
  parent.resize(bodies);
  std::iota(parent.begin(), parent.end(), 0);
}

/// The root of a body's tree. Paths are halved on the way (Tarjan & van Leeuwen 1984).
inline Index root_of(std::vector<Index>& parent, Index body) {
  while (parent[body] != body) {
    parent[body] = parent[parent[body]];
    body = parent[body];
  }
  return body;
}

/// Joins two trees. The smaller index becomes the root, whatever the order of the calls.
inline void join(std::vector<Index>& parent, Index a, Index b) {
  const Index root_a = root_of(parent, a);
  const Index root_b = root_of(parent, b);
  parent[std::max(root_a, root_b)] = std::min(root_a, root_b);
}

}  // namespace cs550
