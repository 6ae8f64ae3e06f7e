#pragma once
/// @file feature_retest.hpp
/// Temporal coherence of pairs that have moved: only the features of the last answer are queried again, by
/// labs 3 to 5, and points of the bodies prove that no other axis is better. The proof is in the book's
/// chapter on performance.

#include "engine/pairs/temporal_coherence.hpp"

namespace cs550 {

/// The last features at the current poses.
struct RetestedFeatures {
  SeparatingAxis axis;  ///< of its queries only those of the last features are not empty
  Manifold manifold;    ///< without impulses
};

/// Queries the better face of the pair's last axis again, and its edges if they gave that axis.
/// @param margin of this step, see contact_margin() (m)
/// @param now receives the result; pass an empty one
/// @returns whether the result is valid. It is not if the pair had no contact points, if the features separate the
///          bodies by more than the margin, if the edges no longer form a face of the Minkowski difference, or if
///          nothing proves that no axis is better by more than tie_tolerance: a valid separation is as exact as
///          that of a full query. The manifold may be of edges where a full query would find that another
///          face has become the best one and is near enough to replace them (edge_preference).
bool retest_features(const WorldState& world, std::size_t pair, Real margin, RetestedFeatures& now);

}  // namespace cs550
