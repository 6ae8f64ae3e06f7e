#pragma once
/// @file reference_retest.hpp
/// Temporal coherence of pairs that have moved: only the last reference face is queried and clipped,
/// by labs 3 and 5, and a contact point proves that no other axis is better. The proof is in the
/// book's chapter on performance.

#include <optional>

#include "engine/pairs/temporal_coherence.hpp"

namespace cs550 {

/// How much larger than the separation of the retested face the true one may be, relative to the
/// smaller radius of the two shapes.
inline constexpr Real retest_error = kept_motion;

/// A reference face at the current poses, and its manifold.
struct RetestedFace {
  SeparatingAxis axis;  ///< of its queries only that of the face is not empty
  Manifold manifold;    ///< without impulses
};

/// Queries the face that owned the pair's last manifold again. Nothing is returned if the manifold
/// was none of a face, if the face separates the bodies by more than the margin, or if no contact
/// point proves that the face is still the best axis, up to retest_error.
/// @param margin of this step, see contact_margin() (m)
std::optional<RetestedFace> retest_reference_face(const WorldState& world, std::size_t pair,
                                                  Real margin);

}  // namespace cs550
