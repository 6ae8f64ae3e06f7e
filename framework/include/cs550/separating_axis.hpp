#pragma once
/// @file separating_axis.hpp
/// **Lab 4:** Whether two convex polyhedra overlap, by how much, and along which axis.
/// Document §3.2–3.5; Gregorius, *The Separating Axis Test between Convex Polyhedra* (GDC 2013);
/// Ericson, *Real-Time Collision Detection* (2005), §5.2.

#include "cs550/convex_shape.hpp"

namespace cs550 {

/// The best face of one body against the other.
struct FaceQuery {
  Index face = no_index;    ///< of the body whose faces were tried
  Index vertex = no_index;  ///< of the other body: its deepest vertex behind that face
  Real separation = 0;      ///< signed distance of the vertex from the face (m)

  /// Whether a face was found.
  explicit operator bool() const { return face != no_index; }
};

/// The best pair of edges; false when no arcs of the two Gauss maps cross.
struct EdgeQuery {
  Index edge_a = no_index;  ///< half-edge of A
  Index edge_b = no_index;  ///< half-edge of B
  Vec3 axis = {0, 0, 0};    ///< unit, A → B, world frame
  Real separation = 0;      ///< axis·(p_B − p_A), p on the edges (m)

  /// Whether any pair of edges counts.
  explicit operator bool() const { return edge_a != no_index; }
};

/// Which features give the axis.
enum class AxisFeature : std::uint8_t {
  None,   ///< no axis yet
  FaceA,  ///< a face normal of A
  FaceB,  ///< a face normal of B, negated
  Edges,  ///< the cross product of an edge of A and an edge of B
};

/// The axis of largest separation that was found, and the queries behind it. The queries that an
/// early out did not reach are empty (they test false).
struct SeparatingAxis {
  AxisFeature feature = AxisFeature::None;  ///< what gives the axis
  Vec3 axis = {0, 0, 0};                    ///< unit, A → B, world frame
  Real separation = 0;  ///< along the axis: positive apart, negative overlapping (m)
  FaceQuery face_a;     ///< faces of A against vertices of B
  FaceQuery face_b;     ///< faces of B against vertices of A
  EdgeQuery edges;      ///< edges of A against edges of B
};

/// **L4.1** Whether two edges make a face of the Minkowski difference: whether the arc from a to b
/// on the Gauss map of A crosses the arc from c to d on that of −B (document §3.4). True only for
/// a proper crossing: arcs that merely touch give a face that the face queries already cover.
/// @param a, b normals of the two faces beside A's edge (unit, any common frame)
/// @param c, d **negated** normals of the two faces beside B's edge (same frame)
bool is_minkowski_face(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// **L4.2** Tries every face normal of A: the largest over A's faces of the smallest signed distance
/// of B's vertices. The first of several equal faces wins. For B's faces, swap the arguments.
FaceQuery query_face_directions(const PosedShape& a, const PosedShape& b);

/// **L4.3** Tries every pair of edges that make a Minkowski face: the largest separation
/// n·(p_B − p_A) with n = ±(e_A × e_B)/|e_A × e_B|, oriented by the arc (n points with the sum of
/// the normals of A's two faces). Pairs with a sine below parallel_sine are skipped: the faces
/// beside them say the same.
EdgeQuery query_edge_directions(const PosedShape& a, const PosedShape& b);

/// Edges that enclose a smaller sine count as parallel. Relative, so that 1 mm and 1 km are alike.
inline constexpr Real parallel_sine = Real(1e-3);

/// Two separations closer than this, relative to the smaller radius of the two shapes, are a tie.
inline constexpr Real tie_tolerance = Real(1e-4);

/// **L4.4** The axis of largest separation over faces of A, faces of B and edges.
///
/// On a tie (tie_tolerance) the feature kind of the hint wins, then A's face, then B's, then edges:
/// contacts do not flicker between equal axes. A separation above the margin is an early out: any
/// such axis will do, the hint's own features tried first. Swapping A and B keeps the separation,
/// and the axis up to sign where the largest is unique.
/// @param hint   last step's answer for this pair, or a default-made one
/// @param margin separations above it need no exact answer (m); HUGE_VALF never stops early
SeparatingAxis find_separating_axis(const PosedShape& a, const PosedShape& b,
                                    const SeparatingAxis& hint, Real margin);

/// **L4.5** Whether the bodies touch or overlap: no axis has a positive separation (document §3.5).
bool overlap(const PosedShape& a, const PosedShape& b);

}  // namespace cs550
