/// @file clipping.cpp
/// Lab 5, reference. Document §3.6–3.7; Sutherland & Hodgman (1974); Gregorius, *Robust Contact
/// Creation for Physics Simulations* (GDC 2015); Ericson, *Real-Time Collision Detection*, §5.1.9.
///
/// Polygons are clipped in the reference body's frame: its planes need no transformation, and only
/// the distance between the bodies matters, not how far they are from the world's origin.

#include "cs550/clipping.hpp"

#include <algorithm>

namespace cs550 {
namespace {

using Kind = FeatureId::Kind;

Real smaller_radius(const PosedShape& a, const PosedShape& b) {
  return std::min(a.shape->radius, b.shape->radius);
}

/// Where one body is, seen from another: maps points of `body` into the frame of `observer`.
Pose relative_pose(const Pose& body, const Pose& observer) {
  return {observer.to_body(body.position), observer.orientation.conjugate() * body.orientation};
}

/// The same kind of point with the reference face on B: the kinds for B follow those for A.
Kind called_on_b(Kind kind_on_a) {
  constexpr int a_to_b =
      static_cast<int>(Kind::VertexOnFaceB) - static_cast<int>(Kind::VertexOnFaceA);
  return static_cast<Kind>(static_cast<int>(kind_on_a) + a_to_b);
}

/// A reference face, and the body that is clipped against it.
struct ReferenceFace {
  const PosedShape& body;
  const PosedShape& incident;
  Index face;
  bool on_a;

  ReferenceFace(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis)
      : body(axis.feature == AxisFeature::FaceA ? a : b),
        incident(axis.feature == AxisFeature::FaceA ? b : a),
        face(axis.feature == AxisFeature::FaceA ? axis.face_a.face : axis.face_b.face),
        on_a(axis.feature == AxisFeature::FaceA) {}

  const Plane& plane() const { return body.mesh().face(face).plane; }

  /// @param kind_on_a as it is called when A owns the reference face
  FeatureId feature(Kind kind_on_a, Index of_reference, Index of_incident) const {
    if (on_a) return {kind_on_a, of_reference, of_incident};
    return {called_on_b(kind_on_a), of_incident, of_reference};
  }

  /// The contact of a point on the incident body and its projection onto the plane.
  /// @param point in the reference body's frame
  /// @param incident_frame the incident body, seen from the reference body
  ContactPoint contact(const Vec3& point, const Pose& incident_frame, FeatureId id) const {
    const Real separation = plane().distance(point);
    const Vec3 projection = point - separation * plane().normal;
    ContactPoint contact;
    contact.anchor_a = on_a ? projection : incident_frame.to_body(point);
    contact.anchor_b = on_a ? incident_frame.to_body(point) : projection;
    contact.separation = separation;
    contact.feature = id;
    return contact;
  }

  /// A manifold along this face that has no points yet.
  Manifold empty_manifold() const {
    const Vec3 edge = body.mesh().edge_vector(body.mesh().face(face).edge);
    const Vec3 tangent = (edge - edge.dot(plane().normal) * plane().normal).normalized();
    Manifold manifold;
    manifold.normal = body.pose.rotate(on_a ? plane().normal : Vec3(-plane().normal));
    manifold.tangent = body.pose.rotate(tangent);
    manifold.reference = on_a ? AxisFeature::FaceA : AxisFeature::FaceB;
    return manifold;
  }
};

/// A face as a polygon, its corners named by the half-edges of its loop.
ClipPolygon face_polygon(const HalfEdgeMesh& mesh, Index face, const Pose& pose) {
  ClipPolygon polygon;
  for (const Index e : face_edges(mesh, face)) {
    const HalfEdge& half = mesh.edge(e);
    polygon.push_back({pose.to_world(mesh.vertex(half.vertex)),
                       {ClipEdge::Source::Incident, e},
                       {ClipEdge::Source::Incident, half.next}});
  }
  return polygon;
}

/// The plane through an edge of a face, perpendicular to the face, facing out of it.
Plane side_plane(const HalfEdgeMesh& mesh, Index edge, const Vec3& face_normal, Real outward) {
  const Vec3 normal = mesh.edge_vector(edge).cross(face_normal).normalized();
  return {normal, normal.dot(mesh.vertex(mesh.origin(edge))) + outward};
}

bool is_inside(const ClipPolygon& polygon, const Plane& plane) {
  return std::all_of(polygon.begin(), polygon.end(),
                     [&](const ClipVertex& corner) { return plane.distance(corner.point) <= 0; });
}

/// Names a corner by the two edges that meet in it.
FeatureId corner_feature(const ClipVertex& corner, const ReferenceFace& reference,
                         Index incident_face) {
  const bool in_is_incident = corner.in.source == ClipEdge::Source::Incident;
  const bool out_is_incident = corner.out.source == ClipEdge::Source::Incident;
  if (in_is_incident && out_is_incident) {
    return reference.feature(Kind::VertexOnFaceA, reference.face,
                             reference.incident.mesh().edge(corner.in.edge).vertex);
  }
  if (!in_is_incident && !out_is_incident) {
    // The polygon runs clockwise about the reference face: it comes in along the later side.
    return reference.feature(Kind::CornerOfFaceA, reference.body.mesh().origin(corner.in.edge),
                             incident_face);
  }
  const ClipEdge& side = in_is_incident ? corner.out : corner.in;
  const ClipEdge& clipped = in_is_incident ? corner.in : corner.out;
  return reference.feature(Kind::CrossingOnA, side.edge / 2, clipped.edge / 2);
}

/// An edge as the points start + s·along, 0 ≤ s ≤ 1.
struct Segment {
  Vec3 start;
  Vec3 along;

  Vec3 at(Real s) const { return start + s * along; }
  /// The parameter of the point of the segment that is closest to another point.
  Real closest(const Vec3& point) const {
    return std::clamp((point - start).dot(along) / along.squaredNorm(), Real(0), Real(1));
  }
};

/// The parameter on a of the point that is closest to the *line* of b, clamped to the segment.
Real closest_to_line(const Segment& a, const Segment& b) {
  const Vec3 cross = a.along.cross(b.along);
  const Real squared = cross.squaredNorm();
  if (squared == 0) return 0;  // parallel: any point will do
  return std::clamp((b.start - a.start).cross(b.along).dot(cross) / squared, Real(0), Real(1));
}

/// Twice the area of a triangle of contact points: positive if it runs counter-clockwise about the
/// normal.
Real doubled_area(const ContactPoint& p, const ContactPoint& q, const ContactPoint& r,
                  const Vec3& normal) {
  return normal.dot((q.anchor_a - p.anchor_a).cross(r.anchor_a - p.anchor_a));
}

/// The point with the largest measure; the first of several equal ones.
template <class Measure>
const ContactPoint& largest(std::span<const ContactPoint> points, Measure measure) {
  return *std::max_element(
      points.begin(), points.end(),
      [&](const ContactPoint& p, const ContactPoint& q) { return measure(p) < measure(q); });
}

Real deepest_separation(const Manifold& manifold) {
  Real deepest = HUGE_VALF;
  for (const ContactPoint& point : manifold.points) deepest = std::min(deepest, point.separation);
  return deepest;
}

/// The kind of the better face query; the axis's own kind where they are equal.
AxisFeature better_face(const SeparatingAxis& axis, Real tolerance) {
  const Real a = axis.face_a ? axis.face_a.separation : -HUGE_VALF;
  const Real b = axis.face_b ? axis.face_b.separation : -HUGE_VALF;
  if (axis.feature == AxisFeature::FaceB) {
    return b >= a - tolerance ? AxisFeature::FaceB : AxisFeature::FaceA;
  }
  return a >= b - tolerance ? AxisFeature::FaceA : AxisFeature::FaceB;
}

/// One point: the vertex that the face query found deepest.
Manifold vertex_manifold(const ReferenceFace& reference, Index vertex) {
  const Pose incident_frame = relative_pose(reference.incident.pose, reference.body.pose);
  const Vec3 point = incident_frame.to_world(reference.incident.mesh().vertex(vertex));
  Manifold manifold = reference.empty_manifold();
  manifold.points.push_back(reference.contact(
      point, incident_frame, reference.feature(Kind::VertexOnFaceA, reference.face, vertex)));
  return manifold;
}

}  // namespace

ClipPolygon clip_polygon(const ClipPolygon& polygon, const Plane& plane, ClipEdge plane_edge) {
  ClipPolygon clipped;
  if (polygon.empty()) return clipped;

  Real before = plane.distance(polygon.back().point);
  Real here = plane.distance(polygon[0].point);
  for (int i = 0; i < polygon.size(); ++i) {
    const ClipVertex& a = polygon[i];
    const ClipVertex& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const Real after = plane.distance(b.point);

    if (here <= 0) {
      clipped.push_back(a);
      // The outline passes through the plane in this corner: no intersection is emitted, the corner
      // takes its place.
      if (here == 0 && before > 0 && after < 0) clipped.back().in = plane_edge;
      if (here == 0 && before < 0 && after > 0) clipped.back().out = plane_edge;
    }
    const bool leaves = here < 0 && after > 0;
    const bool enters = here > 0 && after < 0;
    if (leaves || enters) {
      const Vec3 intersection = a.point + (here / (here - after)) * (b.point - a.point);
      clipped.push_back({intersection, leaves ? a.out : plane_edge, leaves ? plane_edge : a.out});
    }
    before = here;
    here = after;
  }
  return clipped;
}

Index find_incident_face(const PosedShape& body, const Vec3& reference_normal) {
  const Vec3 normal = body.pose.unrotate(reference_normal);
  const HalfEdgeMesh& mesh = body.mesh();
  Index best = 0;
  Real smallest = HUGE_VALF;
  for (Index face = 0; face < mesh.face_count(); ++face) {
    const Real cosine = normal.dot(mesh.face(face).plane.normal);
    if (cosine < smallest) {
      smallest = cosine;
      best = face;
    }
  }
  return best;
}

Manifold face_manifold(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis,
                       Real margin) {
  const ReferenceFace reference(a, b, axis);
  const HalfEdgeMesh& mesh = reference.body.mesh();
  const Plane& plane = reference.plane();
  const Pose incident_frame = relative_pose(reference.incident.pose, reference.body.pose);

  const Index incident_face =
      find_incident_face(reference.incident, reference.body.pose.rotate(plane.normal));
  ClipPolygon polygon = face_polygon(reference.incident.mesh(), incident_face, incident_frame);
  const Real tolerance = side_plane_tolerance * smaller_radius(a, b);
  for (const Index e : face_edges(mesh, reference.face)) {
    const Plane side = side_plane(mesh, e, plane.normal, tolerance);
    if (!is_inside(polygon, side)) {
      polygon = clip_polygon(polygon, side, {ClipEdge::Source::Reference, e});
    }
  }

  StaticVector<ContactPoint, ClipPolygon::capacity()> points;
  for (const ClipVertex& corner : polygon) {
    if (plane.distance(corner.point) > margin) continue;
    points.push_back(reference.contact(corner.point, incident_frame,
                                       corner_feature(corner, reference, incident_face)));
  }
  Manifold manifold = reference.empty_manifold();
  manifold.points = reduce_manifold({points.data(), static_cast<std::size_t>(points.size())},
                                    a.pose.unrotate(manifold.normal));
  return manifold;
}

Manifold edge_manifold(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis) {
  const EdgeQuery& edges = axis.edges;
  const Pose b_in_a = relative_pose(b.pose, a.pose);
  const Segment edge_a{a.mesh().vertex(a.mesh().origin(edges.edge_a)),
                       a.mesh().edge_vector(edges.edge_a)};
  const Segment edge_b{b_in_a.to_world(b.mesh().vertex(b.mesh().origin(edges.edge_b))),
                       b_in_a.rotate(b.mesh().edge_vector(edges.edge_b))};

  // Clamping one parameter moves the best value of the other (Ericson §5.1.9).
  const Real t = edge_b.closest(edge_a.at(closest_to_line(edge_a, edge_b)));
  const Real s = edge_a.closest(edge_b.at(t));

  const Vec3 normal = a.pose.unrotate(edges.axis);
  ContactPoint point;
  point.anchor_a = edge_a.at(s);
  point.anchor_b = b_in_a.to_body(edge_b.at(t));
  point.separation = normal.dot(edge_b.at(t) - edge_a.at(s));
  point.feature = {Kind::Edges, edges.edge_a / 2, edges.edge_b / 2};

  Manifold manifold;
  manifold.normal = edges.axis;
  manifold.tangent = a.pose.rotate((edge_a.along - edge_a.along.dot(normal) * normal).normalized());
  manifold.reference = AxisFeature::Edges;
  manifold.points.push_back(point);
  return manifold;
}

StaticVector<ContactPoint, max_manifold_points> reduce_manifold(
    std::span<const ContactPoint> points, const Vec3& normal) {
  StaticVector<ContactPoint, max_manifold_points> kept;
  if (points.size() <= max_manifold_points) {
    for (const ContactPoint& point : points) kept.push_back(point);
    return kept;
  }

  const ContactPoint& deepest =
      largest(points, [](const ContactPoint& p) { return -p.separation; });
  kept.push_back(deepest);

  const auto distance = [&](const ContactPoint& p) {
    return normal.cross(p.anchor_a - deepest.anchor_a).squaredNorm();
  };
  const ContactPoint& farthest = largest(points, distance);
  if (distance(farthest) == 0) return kept;  // all points coincide
  kept.push_back(farthest);

  const auto triangle_area = [&](const ContactPoint& p) {
    return std::abs(doubled_area(deepest, farthest, p, normal));
  };
  const ContactPoint& third = largest(points, triangle_area);
  if (triangle_area(third) == 0) return kept;  // all points on one line
  kept.push_back(third);

  const bool counter_clockwise = doubled_area(deepest, farthest, third, normal) > 0;
  const ContactPoint& second = counter_clockwise ? farthest : third;
  const ContactPoint& last = counter_clockwise ? third : farthest;
  const auto added_area = [&](const ContactPoint& p) {
    return std::max({doubled_area(second, deepest, p, normal),
                     doubled_area(last, second, p, normal),
                     doubled_area(deepest, last, p, normal)});
  };
  const ContactPoint& fourth = largest(points, added_area);
  if (added_area(fourth) > 0) kept.push_back(fourth);
  return kept;
}

Manifold build_manifold(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis,
                        Real margin) {
  if (axis.feature == AxisFeature::None || axis.separation > margin) return {};
  if (!axis.face_a && !axis.face_b) return edge_manifold(a, b, axis);

  const Real radius = smaller_radius(a, b);
  SeparatingAxis face_axis = axis;
  face_axis.feature = better_face(axis, tie_tolerance * radius);
  const FaceQuery& face = face_axis.feature == AxisFeature::FaceA ? axis.face_a : axis.face_b;

  const Real preference = edge_preference * radius;
  if (axis.edges && axis.edges.separation > face.separation + preference) {
    return edge_manifold(a, b, axis);
  }

  Manifold manifold = face_manifold(a, b, face_axis, margin);
  const bool lost_the_deepest = deepest_separation(manifold) > face.separation + preference;
  if (!lost_the_deepest) return manifold;
  if (axis.edges && axis.edges.separation >= face.separation) return edge_manifold(a, b, axis);
  if (axis.separation > 0 && !manifold.points.empty()) return manifold;
  return vertex_manifold(ReferenceFace(a, b, face_axis), face.vertex);
}

}  // namespace cs550
