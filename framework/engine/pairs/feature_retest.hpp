#pragma once
/// @file feature_retest.hpp
/// Temporal coherence of pairs that have moved: only the features of the last answer are queried again, by
/// labs 3 to 5, and points of the bodies prove that no other axis is better. The proof is in the book's
/// chapter on performance.

#include "engine/pairs/temporal_coherence.hpp"

namespace cs550 {

/// The last features at the current poses.
struct RetestedFeatures {
  SeparatingAxis axis;  ///< queries of other features are empty
  Manifold manifold;    ///< without impulses
};

/// Queries the features of the pair's last axis again, and with edges all faces.
/// @param margin of this step, see contact_margin() (m)
/// @param now receives the result; pass an empty one
/// @returns whether the result is valid. It is not if the pair had no contact points, if the features separate the
///          bodies by more than the margin, if the edges no longer form a face of the Minkowski difference, or if
///          nothing proves that no axis is better by more than tie_tolerance: a valid result is as exact as
///          that of a full query.
bool retest_features(const WorldState& world, std::size_t pair, Real margin, RetestedFeatures& now);

}  // namespace cs550
