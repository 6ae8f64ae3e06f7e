#pragma once
/// @file separating_axis.hpp
/// **Lab 4:** The separating axis test: whether two convex polyhedra overlap, by how much, and
/// along which axis. Document §3.2–3.5; Gregorius, *The Separating Axis Test between Convex
/// Polyhedra* (GDC 2013); Ericson, *Real-Time Collision Detection* (2005), §5.2.

#include "cs550/convex_shape.hpp"

namespace cs550 {

/// The face normal of one body that separates best from the other body. Empty by default.
struct FaceQuery {
  Index face = no_index;    ///< of the body whose faces are tested
  Index vertex = no_index;  ///< of the other body: the vertex deepest behind that face
  Real separation = 0;      ///< signed distance of the vertex from the face (m)

  /// Whether a face was found.
  explicit operator bool() const { return face != no_index; }
};

/// The pair of edges that separates best. Empty, with a separation of 0, if no arcs of the two
/// Gauss maps cross: test it before comparing its separation.
struct EdgeQuery {
  Index edge_a = no_index;  ///< half-edge of A
  Index edge_b = no_index;  ///< half-edge of B
  Vec3 axis = {0, 0, 0};    ///< unit, A → B, world frame
  Real separation = 0;      ///< axis·(p_B − p_A) for points p on the edges (m)

  /// Whether a pair of edges was found.
  explicit operator bool() const { return edge_a != no_index; }
};

/// The features that define an axis.
enum class AxisFeature : std::uint8_t {
  None,   ///< no axis yet
  FaceA,  ///< a face normal of A
  FaceB,  ///< a face normal of B, negated
  Edges,  ///< the cross product of an edge of A and an edge of B
};

/// The axis of largest separation that was found, and the queries that led to it. Queries that an
/// early out did not reach are empty (they convert to false).
struct SeparatingAxis {
  AxisFeature feature = AxisFeature::None;  ///< the features that define the axis
  Vec3 axis = {0, 0, 0};                    ///< unit, A → B, world frame
  Real separation = 0;  ///< along the axis: positive apart, negative overlapping (m)
  FaceQuery face_a;     ///< faces of A against vertices of B
  FaceQuery face_b;     ///< faces of B against vertices of A
  EdgeQuery edges;      ///< edges of A against edges of B
};

/// **L4.1** Whether two edges form a face of the Minkowski difference: whether the arc from a to b
/// on the Gauss map of A crosses the arc from c to d on that of −B (document §3.4). Only a proper
/// crossing counts. Arcs that merely touch belong to a face that the face queries already test.
/// @param a, b normals of the two faces beside A's edge (unit, any common frame)
/// @param c, d **negated** normals of the two faces beside B's edge (same frame)
bool is_minkowski_face(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// **L4.2** Tests every face normal of A. The separation of a face is the smallest signed distance
/// of B's vertices from it; the result is the face with the largest separation. On a tie the face
/// with the smallest index wins. For B's faces, swap the arguments.
FaceQuery query_face_directions(const PosedShape& a, const PosedShape& b);

/// **L4.3** Tests every pair of edges that form a Minkowski face. The axis of a pair is
/// perpendicular to both edges and points out of A at A's edge, which the adjacent face normals
/// decide. The result is the pair with the largest signed separation along its axis, or an empty
/// query. Pairs that enclose a sine below parallel_sine are skipped, because the adjacent faces
/// cover that direction. Each edge is visited once, by its half-edge of even number, and the result
/// names these.
EdgeQuery query_edge_directions(const PosedShape& a, const PosedShape& b);

/// Edges that enclose a smaller sine count as parallel. A relative measure works from 1 mm to 1 km.
inline constexpr Real parallel_sine = Real(1e-3);

/// Separations that differ by no more than this, relative to the smaller radius of the two shapes,
/// are a tie.
inline constexpr Real tie_tolerance = Real(1e-4);

/// **L4.4** The axis of largest separation over the faces of A, the faces of B and the edges.
///
/// - Tie (see tie_tolerance): the kind of feature in the hint wins, then A's face, then B's face,
///   then the edges, so that contacts do not flicker between equally good axes.
/// - Early out: as soon as a separation exceeds the margin, that axis is returned. The features of
///   the hint are tested first, at the current poses.
/// - Swapping A and B leaves the separation unchanged and reverses the axis, if the maximum is
///   unique.
/// @param hint result of the last step for this pair, or a default-constructed one
/// @param margin separations above it need no exact answer (m); HUGE_VALF disables the early out
SeparatingAxis find_separating_axis(const PosedShape& a, const PosedShape& b,
                                    const SeparatingAxis& hint, Real margin);

/// **L4.5** Whether two bodies touch or overlap, so that no axis has a positive separation
/// (document §3.5).
bool overlap(const PosedShape& a, const PosedShape& b);

}  // namespace cs550
