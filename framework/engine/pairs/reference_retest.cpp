#include "engine/pairs/reference_retest.hpp"

#include <algorithm>

#include "cs550/clipping.hpp"
#include "cs550/hill_climbing.hpp"
#include "engine/pairs/relative_pose.hpp"
#include "engine/pairs/separation_bound.hpp"

namespace cs550 {

namespace {

/// The query of one face at the current poses.
FaceQuery query_again(const FaceQuery& last, const PosedShape& body, const PosedShape& other) {
  const Plane& plane = body.mesh().face(last.face).plane;
  const Pose other_in_body = seen_from(body.pose, other.pose);
  const Vec3 inward = other_in_body.unrotate(-plane.normal);
  const Index vertex = hill_climb(other.mesh(), inward, last.vertex).vertex;
  return {last.face, vertex, plane.distance(other_in_body.to_world(other.mesh().vertex(vertex)))};
}

Real deepest_separation(const Manifold& manifold) {
  Real deepest = HUGE_VALF;
  for (const ContactPoint& point : manifold.points) deepest = std::min(deepest, point.separation);
  return deepest;
}

}  // namespace

std::optional<RetestedFace> retest_reference_face(const WorldState& world, std::size_t pair,
                                                  Real margin) {
  if (!world.pairs.has_points(pair)) return {};
  const Contact& contact = world.pairs.contacts[pair];
  const SeparatingAxis& last = world.pairs.axes[pair];
  const AxisFeature reference = contact.manifold.reference;
  const bool on_b = reference == AxisFeature::FaceB;
  const FaceQuery& last_query = on_b ? last.face_b : last.face_a;
  if (reference == AxisFeature::Edges || !last_query) return {};

  const PosedShape a = world.posed_shape(contact.body_a);
  const PosedShape b = world.posed_shape(contact.body_b);
  const FaceQuery query = on_b ? query_again(last_query, b, a) : query_again(last_query, a, b);
  if (query.separation > margin) return {};

  RetestedFace face;
  face.axis.feature = reference;
  (on_b ? face.axis.face_b : face.axis.face_a) = query;
  face.axis.separation = query.separation;
  face.manifold = face_manifold(a, b, face.axis, margin);
  face.axis.axis = face.manifold.normal;
  if (face.manifold.points.empty()) return {};

  const SeparationBound bound{face.manifold.normal, deepest_separation(face.manifold),
                              b.pose.position - a.pose.position,
                              a.shape->inner_radius + b.shape->inner_radius};
  const Real error = retest_error * std::min(a.shape->radius, b.shape->radius);
  if (!bound.stays_below(query.separation + error)) return {};
  return face;
}

}  // namespace cs550
