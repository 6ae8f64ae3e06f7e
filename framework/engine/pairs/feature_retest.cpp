#include "engine/pairs/feature_retest.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "cs550/clipping.hpp"
#include "cs550/separating_axis.hpp"
#include "engine/pairs/axis_promise.hpp"
#include "engine/pairs/minkowski_difference.hpp"

namespace cs550 {

namespace {

/// One feature of the last axis at the current poses. Lab 4 tests the feature of a hint first and returns it at
/// once if it separates by more than the margin, as every feature does here.
/// @returns another feature if edges no longer form a face of the Minkowski difference
// With a copy of the whole query in each place that calls it, a retest took a tenth longer.
[[gnu::noinline]] SeparatingAxis query_again(const PosedShape& a, const PosedShape& b,
                                             SeparatingAxis last, AxisFeature feature) {
  last.feature = feature;
  return find_separating_axis(a, b, last, -HUGE_VALF);
}

/// The face that separates best, or None.
AxisFeature better_face(const SeparatingAxis& axis) {
  if (axis.feature == AxisFeature::FaceA || axis.feature == AxisFeature::FaceB) return axis.feature;
  if (!axis.face_a) return axis.face_b ? AxisFeature::FaceB : AxisFeature::None;
  if (!axis.face_b) return AxisFeature::FaceA;
  return axis.face_a.separation >= axis.face_b.separation ? AxisFeature::FaceA : AxisFeature::FaceB;
}

/// The better face of the last axis, and its edges if they gave it, at the current poses.
/// @returns no feature if edges no longer form a face of the Minkowski difference
SeparatingAxis query_features_again(const PosedShape& a, const PosedShape& b,
                                    const SeparatingAxis& last) {
  SeparatingAxis now;
  const AxisFeature face = better_face(last);
  if (face != AxisFeature::None) now = query_again(a, b, last, face);
  if (last.feature != AxisFeature::Edges) return now;

  const SeparatingAxis edges = query_again(a, b, last, AxisFeature::Edges);
  if (edges.feature != AxisFeature::Edges) return {};
  now.edges = edges.edges;
  const bool face_is_better = face != AxisFeature::None && now.separation >= edges.separation;
  if (face_is_better) return now;
  now.feature = AxisFeature::Edges;
  now.axis = edges.axis;
  now.separation = edges.separation;
  return now;
}

/// The middle of the contact points on the body that does not own the reference face, of those with at most
/// this separation.
std::optional<Vec3> middle_of_incident_points(const Manifold& manifold, Real separation) {
  Vec3 sum = Vec3::Zero();
  Real count = 0;
  for (const ContactPoint& point : manifold.points) {
    if (point.separation > separation) continue;
    sum += manifold.reference == AxisFeature::FaceA ? point.anchor_b : point.anchor_a;
    ++count;
  }
  if (count == 0) return {};
  return sum / count;
}

/// The proof for the axis of a face: its corners, as seen from a point behind it.
bool face_proves(const PosedShape& body, const PosedShape& other, const FaceQuery& query,
                 const Vec3& point_of_other, Real limit) {
  const HalfEdgeMesh& mesh = body.mesh();
  const Face& face = mesh.face(query.face);
  MinkowskiDifference difference(other, query.vertex, body, mesh.edge(face.edge).vertex);
  const Vec3 point = difference.from_other(point_of_other);
  StaticVector<Vec3, max_face_vertices> base;
  for (const Index edge : face_edges(mesh, query.face)) {
    base.push_back(point - mesh.vertex(mesh.edge(edge).vertex));
  }
  return difference.limits_separation(limit, {base.begin(), base.end()}, face.plane.normal);
}

/// The proof for the axis of two edges: their ends differ by the corners of a parallelogram.
bool edges_prove(const PosedShape& a, const PosedShape& b, const EdgeQuery& edges, Real limit) {
  const auto ends = [](const HalfEdgeMesh& mesh, Index edge) {
    return std::pair(mesh.origin(edge), mesh.edge(edge).vertex);
  };
  const auto [from_a, to_a] = ends(a.mesh(), edges.edge_a);
  const auto [from_b, to_b] = ends(b.mesh(), edges.edge_b);
  MinkowskiDifference difference(b, from_b, a, from_a);
  const auto on_b = [&](Index vertex) { return difference.from_other(b.mesh().vertex(vertex)); };
  const auto on_a = [&](Index vertex) { return a.mesh().vertex(vertex); };
  std::array<Vec3, 4> base = {on_b(from_b) - on_a(from_a), on_b(to_b) - on_a(from_a),
                              on_b(to_b) - on_a(to_a), on_b(from_b) - on_a(to_a)};
  const Vec3 normal = a.pose.unrotate(edges.axis);
  const bool clockwise = (base[1] - base[0]).cross(base[2] - base[1]).dot(normal) < 0;
  if (clockwise) std::swap(base[1], base[3]);
  return difference.limits_separation(limit, base, normal);
}

/// Whether it is proved that no axis separates the bodies by more than the limit.
bool is_proved(const PosedShape& a, const PosedShape& b, const RetestedFeatures& features,
               Real limit) {
  const auto& [axis, manifold] = features;
  if (axis.feature == AxisFeature::Edges) return edges_prove(a, b, axis.edges, limit);
  if (manifold.reference != axis.feature) return false;
  const auto point = middle_of_incident_points(manifold, limit);
  if (!point) return false;
  return axis.feature == AxisFeature::FaceA ? face_proves(a, b, axis.face_a, *point, limit)
                                            : face_proves(b, a, axis.face_b, *point, limit);
}

}  // namespace

bool retest_features(const WorldState& world, std::size_t pair, Real margin,
                     RetestedFeatures& now) {
  if (!world.pairs.has_points(pair)) return false;
  const PairSummary& summary = world.pairs.summaries[pair];
  const PosedShape a = world.posed_shape(summary.body_a);
  const PosedShape b = world.posed_shape(summary.body_b);

  // Across many times their size, float cannot tell where the vertices of one are, seen from the other.
  const Real near = 2 * (a.shape->radius + b.shape->radius);
  if ((b.pose.position - a.pose.position).squaredNorm() > near * near) return false;

  now.axis = query_features_again(a, b, world.pairs.axes[pair]);
  if (world.settings.check_stages && broken_promise(now.axis, a.mesh(), b.mesh())) return false;
  const Real separation = now.axis.separation;
  if (now.axis.feature == AxisFeature::None || separation > margin) return false;
  now.manifold = build_manifold(a, b, now.axis, margin);

  const Real limit = separation + tie_tolerance * std::min(a.shape->radius, b.shape->radius);
  return is_proved(a, b, now, limit);
}

}  // namespace cs550
