/// @file separating_axis.cpp
/// Lab 4 for the engine: the results of the teaching form in a fraction of the time.
///
/// Three observations about s(n) = min over B of n·b − max over A of n·a, the separation along n:
/// 1. Any point w of B bounds it: s(n_f) ≤ the distance of w from face f. One pass over A's faces
///    with a well-chosen *witness* w rules out nearly all of them. The support vertices of the
///    remaining faces are better witnesses (face_bounds.hpp).
/// 2. Along the arc of an edge of A from n_f to n_g, taken as the chord n(t), s is concave, so the
///    same witness bounds it by its distances from both faces. This test rules out most arcs.
/// 3. The crossings of an arc with B's Gauss map are the breakpoints of s along the chord: walking
///    from one to the next finds them without looking at the other edges of B (arc_walk.hpp). Arcs
///    of nearly half a circle are tested against all edges of B: rounding decides such a walk.
///
/// Candidates that cannot beat the best face are not computed, and `edges` is then empty. That includes
/// edges which only tie with it, unless the hint names them: the teaching form prefers these after a
/// hint of other edges, too. Nothing is allocated.

#include "cs550/separating_axis.hpp"

#include <algorithm>

#include "../features.hpp"
#include "arc_walk.hpp"
#include "face_bounds.hpp"
#include "support_search.hpp"

namespace cs550 {

using lab4::best_feature;
using lab4::with_feature;

namespace {

/// Two shapes and their meshes, with the pose of B in A's body frame.
struct Pair {
  const ConvexShape& shape_a;
  const ConvexShape& shape_b;
  const HalfEdgeMesh& a;
  const HalfEdgeMesh& b;
  Mat3 rotation;  ///< B's frame to A's
  Vec3 position;  ///< of B's centroid

  Pair(const PosedShape& body_a, const PosedShape& body_b)
      : shape_a(*body_a.shape),
        shape_b(*body_b.shape),
        a(body_a.mesh()),
        b(body_b.mesh()),
        rotation(
            (body_a.pose.orientation.conjugate() * body_b.pose.orientation).toRotationMatrix()),
        position(body_a.pose.to_body(body_b.pose.position)) {}

  Vec3 to_a(const Vec3& point_of_b) const { return rotation * point_of_b + position; }
  Vec3 to_b(const Vec3& point_of_a) const { return rotation.transpose() * (point_of_a - position); }
  Vec3 turn_to_a(const Vec3& direction) const { return rotation * direction; }
  Vec3 turn_to_b(const Vec3& direction) const { return rotation.transpose() * direction; }
};

FaceQuery query_face(const Pair& pair, Index face, Index start) {
  const Plane plane = plane_of(pair.shape_a, face);
  const Index vertex = lowest_vertex(pair.b, pair.turn_to_b(plane.normal), start);
  return {face, vertex, plane.distance(pair.to_a(pair.b.vertex(vertex)))};
}

/// Of two equal faces the first wins, whatever the order in which they are tried.
bool is_better(const FaceQuery& query, const FaceQuery& best) {
  return !best || query.separation > best.separation ||
         (query.separation == best.separation && query.face < best.face);
}

/// The best face of A, or any with a separation above the margin. Tries the face with the largest
/// bound until there are enough witnesses, then every face that is not ruled out.
/// @param first the query of the face to begin with; the face with the largest bound if empty
/// @param[out] bounds of all faces by the witnesses that were used
FaceQuery query_faces(const Pair& pair, const FaceQuery& first, Real margin, FaceBounds& bounds) {
  bounds.start(pair.shape_a, pair.position);
  FaceQuery best;
  FaceQuery query = first ? first : query_face(pair, bounds.largest(), 0);
  Index face = no_index;
  Index start = no_index;
  while (true) {
    if (is_better(query, best)) best = query;
    if (best.separation > margin) return best;

    bounds.add(pair.to_a(pair.b.vertex(query.vertex)));
    face = bounds.largest();
    start = query.vertex;
    if (face == best.face || bounds.of(face) < best.separation) return best;
    if (bounds.full()) break;
    query = query_face(pair, face, start);
  }
  for (face = 0; face < pair.a.face_count(); ++face) {
    if (bounds.of(face) < best.separation) continue;
    const FaceQuery query = query_face(pair, face, start);
    if (is_better(query, best)) best = query;
    if (best.separation > margin) return best;
    start = query.vertex;
  }
  return best;
}

/// The query of a face of last step at the current poses; empty if there is none.
FaceQuery query_again(const Pair& pair, const FaceQuery& last) {
  return last ? query_face(pair, last.face, last.vertex) : FaceQuery{};
}

/// The pair of edges at a crossing that the walk found, with the axis from their cross product.
/// Empty if the edges are parallel or the arcs merely touch.
EdgeQuery query_edge_pair(const Pair& pair, Index edge_a, Index edge_b) {
  const auto normal = [](const ConvexShape& shape, Index e) {
    return plane_of(shape, shape.mesh.edge(e).face).normal;
  };
  const Vec3 left = normal(pair.shape_a, edge_a);
  const Vec3 right = normal(pair.shape_a, edge_a ^ 1);
  if (!is_minkowski_face(left, right, -pair.turn_to_a(normal(pair.shape_b, edge_b)),
                         -pair.turn_to_a(normal(pair.shape_b, edge_b ^ 1)))) {
    return {};
  }
  const Vec3 along_a = pair.a.edge_vector(edge_a);
  const Vec3 along_b = pair.turn_to_a(pair.b.edge_vector(edge_b));
  const Vec3 cross = along_a.cross(along_b);
  const Real length = cross.norm();
  if (length < parallel_sine * along_a.norm() * along_b.norm()) return {};

  const Real outward = cross.dot(left + right) > 0 ? Real(1) : Real(-1);
  const Vec3 axis = (outward / length) * cross;
  const Vec3 a_to_b =
      pair.to_a(pair.b.vertex(pair.b.origin(edge_b))) - pair.a.vertex(pair.a.origin(edge_a));
  return {edge_a, edge_b, axis, axis.dot(a_to_b)};
}

/// Walks the arcs of A over the Gauss map of B.
class EdgeSearch {
 public:
  explicit EdgeSearch(const Pair& pair) : pair_(pair) {
    std::fill_n(support_.begin(), pair.a.face_count(), no_index);
  }

  /// The best pair of edges of all.
  EdgeQuery best_of_all() {
    for (Index e = 0; e < pair_.a.edge_count(); e += 2) walk(e, arc_of(e));
    return best_;
  }

  /// The best pair of edges that may beat the faces, or any above the margin.
  /// @param hinted  last step's edges at the current poses, may be empty
  /// @param to_beat the separation of the best face, less the tolerance of a tie
  EdgeQuery best_beyond_faces(const EdgeQuery& hinted, FaceBounds& bounds, Real to_beat,
                              Real margin) {
    best_ = hinted;
    const auto floor = [&] { return best_ ? std::max(to_beat, best_.separation) : to_beat; };
    // Where s ≤ 0, s/|n| ≤ s, since |n(t)| ≤ 1.
    bounds.compare_with(std::min(floor(), Real(0)));
    for (Index e = 0; e < pair_.a.edge_count(); e += 2) {
      const Index left = pair_.a.edge(e).face;
      const Index right = pair_.a.edge(e ^ 1).face;
      if (bounds.any_below(left, right)) continue;

      const Arc arc = arc_of(e);
      if (arc.may_beat(floor(), pair_.b.vertex(support(left, arc.from)),
                       pair_.b.vertex(support(right, arc.to)))) {
        walk(e, arc);
        if (best_ && best_.separation > margin) break;
      }
    }
    return best_;
  }

 private:
  /// The arc of an edge of A, in B's frame.
  Arc arc_of(Index e) const {
    const auto normal = [&](Index half) {
      return pair_.turn_to_b(plane_of(pair_.shape_a, pair_.a.edge(half).face).normal);
    };
    return {normal(e), normal(e ^ 1), pair_.to_b(pair_.a.vertex(pair_.a.origin(e))),
            pair_.to_b(pair_.a.vertex(pair_.a.edge(e).vertex))};
  }

  /// B's support vertex against the normal of a face of A (in B's frame), found once.
  Index support(Index face, const Vec3& normal) {
    Index& vertex = support_[face];
    if (vertex == no_index) vertex = lowest_vertex(pair_.b, normal, last_support_);
    return last_support_ = vertex;
  }

  void try_edges(Index edge_a, Index edge_b) {
    const EdgeQuery query = query_edge_pair(pair_, edge_a, edge_b);
    if (query && (!best_ || query.separation > best_.separation)) best_ = query;
  }

  void walk(Index edge_a, const Arc& arc) {
    if (arc.is_nearly_half_a_circle()) {
      for (Index edge_b = 0; edge_b < pair_.b.edge_count(); edge_b += 2) try_edges(edge_a, edge_b);
      return;
    }
    const Index start = support(pair_.a.edge(edge_a).face, arc.from);
    walk_arc(pair_.b, arc, start, [&](Real t, Index edge_b) {
      if (best_ &&
          !arc.may_separate_by(best_.separation, t, pair_.b.vertex(pair_.b.origin(edge_b))))
        return;
      try_edges(edge_a, edge_b & ~1);
    });
  }

  const Pair& pair_;
  EdgeQuery best_;
  Index last_support_ = 0;
  std::array<Index, max_shape_faces> support_;
};

}  // namespace

FaceQuery query_face_directions(const PosedShape& a, const PosedShape& b) {
  FaceBounds bounds;
  return query_faces(Pair(a, b), {}, HUGE_VALF, bounds);
}

EdgeQuery query_edge_directions(const PosedShape& a, const PosedShape& b) {
  const Pair pair(a, b);
  EdgeQuery best = EdgeSearch(pair).best_of_all();
  best.axis = a.pose.rotate(best.axis);
  return best;
}

SeparatingAxis find_separating_axis(const PosedShape& a, const PosedShape& b,
                                    const SeparatingAxis& hint, Real margin) {
  SeparatingAxis result;

  // Last step's feature first: a pair that stays apart needs nothing else, nor both poses.
  EdgeQuery hinted_edges;
  if (hint.feature == AxisFeature::FaceA) {
    result.face_a = query_again(Pair(a, b), hint.face_a);
    if (result.face_a.separation > margin) return with_feature(AxisFeature::FaceA, result, a, b);
  } else if (hint.feature == AxisFeature::FaceB) {
    result.face_b = query_again(Pair(b, a), hint.face_b);
    if (result.face_b.separation > margin) return with_feature(AxisFeature::FaceB, result, a, b);
  } else if (hint.feature == AxisFeature::Edges) {
    hinted_edges = query_edge_pair(Pair(a, b), hint.edges.edge_a, hint.edges.edge_b);
    if (hinted_edges && hinted_edges.separation > margin) {
      result.edges = hinted_edges;
      result.edges.axis = a.pose.rotate(result.edges.axis);
      return with_feature(AxisFeature::Edges, result, a, b);
    }
  }

  const Pair ab(a, b);
  const Pair ba(b, a);
  const FaceQuery tried_a = result.face_a;
  const FaceQuery tried_b = result.face_b;
  FaceBounds bounds;
  result = {};
  result.face_b = query_faces(ba, tried_b ? tried_b : query_again(ba, hint.face_b), margin, bounds);
  if (result.face_b.separation > margin) return with_feature(AxisFeature::FaceB, result, a, b);
  result.face_a = query_faces(ab, tried_a ? tried_a : query_again(ab, hint.face_a), margin, bounds);
  if (result.face_a.separation > margin) return with_feature(AxisFeature::FaceA, result, a, b);

  const Real tolerance = tie_tolerance * std::min(a.shape->radius, b.shape->radius);
  const Real to_beat = std::max(result.face_a.separation, result.face_b.separation) - tolerance;
  result.edges = EdgeSearch(ab).best_beyond_faces(hinted_edges, bounds, to_beat, margin);
  result.edges.axis = a.pose.rotate(result.edges.axis);
  if (result.edges && result.edges.separation > margin) {
    return with_feature(AxisFeature::Edges, result, a, b);
  }
  return with_feature(best_feature(result, hint.feature, tolerance), result, a, b);
}

}  // namespace cs550
