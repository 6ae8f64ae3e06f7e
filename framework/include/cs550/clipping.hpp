#pragma once
/// @file clipping.hpp
/// **Lab 5:** Contact generation: turns a separating axis into a contact manifold by clipping the
/// incident face against the reference face. Document §3.6–3.7; Sutherland & Hodgman (1974);
/// Gregorius, *Robust Contact Creation for Physics Simulations* (GDC 2015).

#include <span>

#include "cs550/contact.hpp"

namespace cs550 {

/// The origin of an edge of a clipped polygon.
struct ClipEdge {
  /// The face that contributed the edge.
  enum class Source : std::uint8_t {
    Incident,   ///< a side of the polygon before clipping
    Reference,  ///< the intersection with a clipping plane
  };
  Source source = Source::Incident;  ///< the face that contributed the edge
  Index edge = no_index;             ///< half-edge of the incident or of the reference body

  /// Whether both name the same edge.
  bool operator==(const ClipEdge& other) const {
    return source == other.source && edge == other.edge;
  }
};

/// A corner of a clipped polygon, named by the two edges that meet there. Two incident edges meet
/// in an incident vertex, an incident edge and a reference edge in a crossing, two reference edges
/// in a corner of the reference face.
struct ClipVertex {
  Vec3 point = {0, 0, 0};  ///< any frame; face_manifold() uses the reference body's (m)
  ClipEdge in;             ///< the edge that ends here, in counter-clockwise order
  ClipEdge out;            ///< the edge that starts here
};

/// A polygon, counter-clockwise about the normal of its face. A plane adds at most one corner to a
/// convex polygon. A face may turn inward by what validate() tolerates, and a plane may then cut it
/// in several places: of n corners, m planes leave at most 2n + m. The capacity suffices for two
/// faces of the largest size.
using ClipPolygon = StaticVector<ClipVertex, 3 * max_face_vertices>;

/// **L5.1** Clips a polygon by a plane and keeps the side where the distance is ≤ 0 (Sutherland &
/// Hodgman). A corner on the plane is kept as it is and emitted once: an intersection is created
/// only between corners strictly on opposite sides. The result keeps the polygon's orientation, may
/// start at any corner, and is empty if nothing is kept.
///
/// Every corner is named by its two edges. The new edge along the plane is called `plane_edge`,
/// also where the outline crosses the plane exactly in a corner. A polygon that the plane does not
/// cross keeps its names.
/// @param plane its normal points away from the kept side; same frame as the polygon
/// @param plane_edge the name of the new edge along the plane
ClipPolygon clip_polygon(const ClipPolygon& polygon, const Plane& plane, ClipEdge plane_edge = {});

/// **L5.2** The incident face: of the faces that meet in the deepest vertex, the one whose normal is
/// most anti-parallel to the reference normal. On a tie the face with the smallest index wins. The
/// most anti-parallel of *all* faces need not touch that vertex.
/// @param body the body that does *not* own the reference face
/// @param vertex its vertex that is deepest behind the reference face, FaceQuery::vertex
/// @param reference_normal world frame, unit, out of the reference body
Index find_incident_face(const PosedShape& body, Index vertex, const Vec3& reference_normal);

/// The distance by which side planes are moved outward before clipping, relative to the smaller
/// radius of the two shapes. Boxes that are stacked flush then keep their feature ids even though
/// their edges differ by rounding.
inline constexpr Real side_plane_tolerance = Real(1e-4);

/// **L5.3** The manifold of two faces. The incident face is clipped by the side planes of the
/// reference face: each contains an edge of that face, is perpendicular to the face, and is moved
/// outward by side_plane_tolerance. Corners with a separation ≤ margin become contact points,
/// reduced to max_manifold_points by reduce_manifold().
///
/// The anchor on the incident body is the clipped corner; the anchor on the reference body is its
/// projection onto the reference plane. The normal points from A to B whichever body owns the
/// reference face. The tangent is parallel to the reference face's first edge, Face::edge.
/// @param axis its feature, FaceA or FaceB, selects the reference face axis.face_a or axis.face_b
/// @param margin largest separation of a contact point (m)
Manifold face_manifold(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis,
                       Real margin);

/// **L5.4** The manifold of two edges: one point with anchors at the closest points of the two
/// *segments* (Ericson §5.1.9). The normal is axis.edges.axis, the tangent is parallel to A's edge.
/// @param axis its edge query is not empty, so the edges are not parallel
Manifold edge_manifold(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis);

/// How much less a point counts the wider the gap that it must cross, see reduce_manifold().
inline constexpr Real gap_penalty = 5;

/// **L5.5** Selects at most four points that support a body nearly as well as all of them do. Up to
/// four points are returned unchanged, in their order. Of more, the deepest point is always kept.
/// The second is the farthest from it, the third spans the largest triangle with them, and the fourth
/// adds the most area beyond one side of that triangle. Distances and areas are measured between the
/// anchors on A, perpendicular to the normal.
///
/// Of points that touch and lie on an ellipse, the selection spans at least 65 % of the largest area
/// (96 % on average) that any four of them including the deepest span. Of more than four points,
/// those that add no area are dropped: no two kept points coincide, and of touching points on one
/// line the deepest one and the end that is farther from it remain.
///
/// A point with a separation s > 0 carries nothing until its gap closes. Wherever it is a candidate,
/// its distance (not the square) or the area that it adds is multiplied by
/// 1 / (1 + gap_penalty · s / margin). So a body that rests on an edge mostly keeps both ends of it.
/// A point with s ≤ 0 counts fully, also if the margin is 0.
/// @param points anchors in body frames
/// @param normal the manifold's normal in A's **body** frame, unit
/// @param margin largest separation of a contact point (m), ≥ 0
StaticVector<ContactPoint, max_manifold_points> reduce_manifold(
    std::span<const ContactPoint> points, const Vec3& normal, Real margin);

/// The lead in separation that an edge contact needs to replace a face contact, relative to the
/// smaller radius of the two shapes. A face is the steadier support.
inline constexpr Real edge_preference = Real(5e-3);

/// **L5.6** The manifold for an axis. It is empty if the axis has no feature or its separation
/// exceeds the margin. Otherwise it has at least one point, since fast bodies would pass through
/// each other without one.
///
/// - Of two faces, the one whose query has the larger separation is the reference face. If they
///   differ by at most tie_tolerance (relative to the smaller radius), axis.feature decides, and A's
///   face wins if that names the edges.
/// - Edges replace a face if they are better by more than edge_preference. Their separation is
///   compared with that of the face's *query*.
/// - For overlapping bodies the deepest point is as deep as the axis, up to edge_preference, even
///   where clipping loses the deepest vertex. If no clipped point is as deep as the face's query, up
///   to edge_preference, the edges replace the face if their separation is not below that of the
///   query. Otherwise the manifold has one point: the deepest vertex of the query, with its
///   projection onto the face, named as a vertex on that face. Bodies that are apart keep their
///   clipped points instead, if there are any. Bodies are apart if axis.separation > 0. At
///   exactly 0 they touch, which counts as overlapping, as in overlap().
///
/// Any query may be empty. An empty query has a separation of 0 and no features, so test the query
/// before comparing its separation. The edge query is empty if no arcs cross, as for aligned boxes;
/// the queries that an early out did not reach are empty as well. If both face queries are empty,
/// the edges are used.
Manifold build_manifold(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis,
                        Real margin);

}  // namespace cs550
