#pragma once
/// @file temporal_coherence.hpp
/// Temporal coherence: the answer of a pair's last query holds for as long as the bodies have
/// hardly moved relative to each other. Nothing is queried here; this decides *when* to ask labs 4
/// and 5 again. The bound and its proof are in the book's chapter on temporal coherence.

#include "engine/world_state.hpp"

namespace cs550 {

/// How far a body of a touching pair may have moved relative to the other since their last query or
/// retest, relative to the smaller radius of the two shapes. The separation of the bodies and that of
/// each kept point change by no more than this. Kept and fresh answers therefore differ by twice as
/// much: 1e-3 of the smaller body's diameter.
inline constexpr Real kept_motion = Real(1e-3);

/// Whether the answer of the pair's last query or retest holds at the current poses:
/// - Without contact points: the surfaces are still farther apart than the margin.
/// - With contact points: neither body has moved more than kept_motion, and no corner of the
///   incident face that the last query left out can be reached in this step. What a full query
///   leaves out, such as vertices beside that face, is left out here, too.
/// @param margin of this step, see contact_margin() (m)
bool answer_holds(const WorldState& world, std::size_t pair, Real margin);

/// Stores the poses and the margin of a query or retest. Queries are remembered while the setting is off, too: it may
/// be switched on.
void remember_query(WorldState& world, std::size_t pair, Real margin);
/// Stores the plane of the manifold that followed, if it has points.
/// @pre the pair's summary is up to date
void remember_plane(WorldState& world, std::size_t pair);

/// Updates a kept manifold. Its plane turns with the body that owns the reference feature, the points
/// stay where they are on the other body, and their separations are measured again. @pre it has points
void move_manifold(WorldState& world, std::size_t pair);

}  // namespace cs550
