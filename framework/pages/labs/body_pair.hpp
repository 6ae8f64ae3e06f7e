#pragma once
/// @file body_pair.hpp
/// The two bodies of the pages of labs 4 and 5.

#include "pages/base/controls.hpp"
#include "pages/labs/shapes.hpp"

namespace cs550::pages {

/// The shapes, and the pose of B. A is at the origin.
struct PairSettings {
  int shape_a = Box;             ///< index in shape_names
  int shape_b = Box;             ///< index in shape_names
  Vec3 position = Vec3::Zero();  ///< of B (m)
  Vec3 turn = Vec3::Zero();      ///< of B, about x, then y, then z (degrees)

  bool operator==(const PairSettings&) const = default;
};

/// Visits the settings.
void describe(PairSettings& settings, ControlVisitor& visit);

/// The bodies with their shapes.
struct BodyPair {
  ShapePtr shape_a;  ///< of A
  ShapePtr shape_b;  ///< of B
  PosedShape a;      ///< world
  PosedShape b;      ///< world

  explicit BodyPair(const PairSettings& settings);
};

}  // namespace cs550::pages
