#pragma once
/// @file hull_pairs.hpp
/// Pairs of random hulls at a given distance.

#include <vector>

#include "cs550/separating_axis.hpp"
#include "helpers/random.hpp"

namespace cs550::bench {

/// Two hulls, and the axis that was found when one of them was elsewhere.
struct HullPair {
  PosedShape a;
  PosedShape b;
  SeparatingAxis hint;
};

/// 64 pairs of hulls with random orientations, b moved along a random direction until their
/// separation is in an interval.
class HullPairs {
 public:
  /// @param vertices of each hull; 0 for unit cubes
  /// @param least, most separation (m)
  HullPairs(int vertices, Real least, Real most);

  /// Moves every b by 2 mm and 0.2°, as a step does. Hints are then of the step before.
  void move();

  static constexpr Real margin = Real(0.02);
  std::vector<HullPair> pairs;

 private:
  std::vector<ShapePtr> shapes_;
};

}  // namespace cs550::bench
