#pragma once
/// @file body_pair.hpp
/// The two bodies of the pages of labs 4 and 5.

#include "pages/base/page.hpp"
#include "pages/labs/shapes.hpp"

namespace cs550::pages {

/// The shapes and poses. A is at the origin until it is moved.
struct PairSettings {
  int shape_a = Box;               ///< index in shape_names
  int shape_b = Box;               ///< index in shape_names
  Vec3 position = Vec3::Zero();    ///< of B (m)
  Vec3 turn = Vec3::Zero();        ///< of B, about x, then y, then z (degrees)
  Vec3 position_a = Vec3::Zero();  ///< of A (m)
  Vec3 turn_a = Vec3::Zero();      ///< of A, about x, then y, then z (degrees)

  bool operator==(const PairSettings&) const = default;
};

/// Visits the settings.
void describe(PairSettings& settings, ControlVisitor& visit);

/// The middles of A and B, which can be moved and turned. See Page.
/// @{
std::vector<Handle> handles(const PairSettings& settings);
void move_handle(PairSettings& settings, std::size_t handle, const Vec3& point);
void turn_handle(PairSettings& settings, std::size_t handle, const Vec3& rotation);
/// @}

/// The bodies with their shapes.
struct BodyPair {
  ShapePtr shape_a;  ///< of A
  ShapePtr shape_b;  ///< of B
  PosedShape a;      ///< world
  PosedShape b;      ///< world

  explicit BodyPair(const PairSettings& settings);
};

}  // namespace cs550::pages
