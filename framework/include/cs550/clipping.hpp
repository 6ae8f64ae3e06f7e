#pragma once
/// @file clipping.hpp
/// **Lab 5:** From an axis to contact points: clip the incident face against the reference face.
/// Document §3.6–3.7; Sutherland & Hodgman (1974); Gregorius, *Robust Contact Creation for Physics
/// Simulations* (GDC 2015).

#include <span>

#include "cs550/contact.hpp"

namespace cs550 {

/// Where an edge of a clipped polygon comes from.
struct ClipEdge {
  /// Whose edge it is.
  enum class Source : std::uint8_t {
    Incident,   ///< a side of the polygon that is clipped
    Reference,  ///< along a plane that clipped it
  };
  Source source = Source::Incident;  ///< whose edge it is
  Index edge = no_index;             ///< half-edge of the incident or of the reference body

  /// Whether both are the same edge.
  bool operator==(const ClipEdge& other) const {
    return source == other.source && edge == other.edge;
  }
};

/// A corner of a clipped polygon. The two edges that meet in it name it: two incident edges are an
/// incident vertex, one of each a crossing, two reference edges a corner of the reference face.
struct ClipVertex {
  Vec3 point = {0, 0, 0};  ///< any frame: face_manifold() takes the reference body's (m)
  ClipEdge in;             ///< the edge that ends here, going counter-clockwise
  ClipEdge out;            ///< the edge that leaves here
};

/// A convex polygon, counter-clockwise about its face's normal. Clipping adds at most one corner per
/// plane, hence the capacity: two faces of the largest size.
using ClipPolygon = StaticVector<ClipVertex, 2 * max_face_vertices>;

/// **L5.1** Clips a polygon by a plane, keeping the side where the distance is ≤ 0 (Sutherland &
/// Hodgman). The document's table, "front" being the side that is kept: front → front emits the
/// second end, behind → front the intersection and the second end, front → behind the intersection,
/// behind → behind nothing. A point on the plane is kept; an intersection is emitted only between
/// ends that are strictly on opposite sides, so no corner appears twice.
/// @param plane normal pointing out of the side that is kept, same frame as the polygon
/// @param plane_edge what the new edge along the plane is called
ClipPolygon clip_polygon(const ClipPolygon& polygon, const Plane& plane, ClipEdge plane_edge = {});

/// **L5.2** The incident face: the one whose normal is most anti-parallel to the reference normal.
/// The first of several equal ones wins.
/// @param body the body that does *not* own the reference face
/// @param reference_normal world frame, unit, out of the reference body
Index find_incident_face(const PosedShape& body, const Vec3& reference_normal);

/// How far outside a side plane a point still counts as on it, relative to the smaller radius of the
/// two shapes. Boxes stacked edge to edge keep the same features although their edges differ by
/// rounding.
inline constexpr Real side_plane_tolerance = Real(1e-4);

/// **L5.3** The manifold of a face against a face: the incident face is clipped by the side planes of
/// the reference face (each through one of its edges, perpendicular to it, moved outward by
/// side_plane_tolerance); of what is left, the points with separation ≤ margin are kept. Each has
/// one anchor at the clipped point, on the incident body, and one at its projection onto the
/// reference plane. The manifold's normal points A → B whichever body owns the reference face, its
/// tangent is along the reference face's first edge. Reduced to max_manifold_points.
/// @param axis its feature, FaceA or FaceB, picks the reference face from axis.face_a or axis.face_b
/// @param margin keep points up to this separation (m)
Manifold face_manifold(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis,
                       Real margin);

/// **L5.4** The manifold of two edges: one point, with anchors at the closest points of the two
/// *segments* (Ericson §5.1.9), normal along axis.edges.axis, tangent along A's edge.
/// @param axis axis.edges is not empty
Manifold edge_manifold(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis);

/// **L5.5** Picks at most four points that support a body nearly as well as all of them: the deepest
/// point, the one farthest from it, the one that spans the largest triangle with these two, and the
/// one that adds the largest area to that triangle. Fewer than five come back unchanged; of more,
/// those that coincide with a chosen one or add no area are left out.
/// @param points anchors in body frames
/// @param normal of the manifold, in A's **body** frame, unit
StaticVector<ContactPoint, max_manifold_points> reduce_manifold(
    std::span<const ContactPoint> points, const Vec3& normal);

/// An edge contact is taken in place of a face only if it is better by this much, relative to the
/// smaller radius of the two shapes: a face is the steadier support.
inline constexpr Real edge_preference = Real(5e-3);

/// **L5.6** The manifold for an axis: of edges if their separation beats the better face query's by
/// edge_preference, else of that face (axis.feature decides between faces that are equal up to
/// tie_tolerance). Like is compared with like: what clipping leaves can be much shallower than the
/// face's separation, and edges that had to beat *that* would leave boxes deep in each other.
///
/// A face manifold without a point that is as deep as the face query says, up to edge_preference,
/// has lost the contact (the incident face need not hold the deepest vertex). It gives way to the
/// edges if their separation is no less than the face's, else, where the bodies overlap or clipping
/// left nothing, to the deepest vertex. So bodies within the margin never get an empty manifold (fast
/// ones that come together sideways would pass through each other), and the depth it reports for
/// bodies that overlap is that of the axis up to edge_preference. A separation above the margin gives
/// an empty manifold.
Manifold build_manifold(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis,
                        Real margin);

}  // namespace cs550
