#pragma once
/// @file answer_indices.hpp
/// Indices in the answer of a submission. Given code and tests use them without a check, so one that
/// names nothing would let a submission read and write the judge's memory.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "cs550/clipping.hpp"
#include "cs550/constraint_solver.hpp"
#include "cs550/hill_climbing.hpp"
#include "serialisation/arguments.hpp"

namespace cs550::grader {

/// An index may also be no_index: that is what it is before a student has written the step that sets it.
/// @throws cereal::Exception unless there is such an element
inline void require_element(Index index, std::size_t count, const char* element) {
  const bool exists = index >= 0 && static_cast<std::size_t>(index) < count;
  if (exists || index == no_index) return;
  throw cereal::Exception("it names " + std::string(element) + ' ' + std::to_string(index) +
                          " of " + std::to_string(count));
}

inline void require_vertex(Index v, const HalfEdgeMesh& mesh) {
  require_element(v, mesh.vertices.size(), "vertex");
}
inline void require_edge(Index e, const HalfEdgeMesh& mesh) {
  require_element(e, mesh.edges.size(), "half-edge");
}
inline void require_face(Index f, const HalfEdgeMesh& mesh) {
  require_element(f, mesh.faces.size(), "face");
}

/// The overload for a function checks what it returned, given its arguments. @throws cereal::Exception
/// @{
template <class Result, class... Arguments>
void check_indices(const Result& /*contains no index*/, const Arguments&... /*arguments*/) {}

inline void check_indices(const HalfEdgeMesh& mesh) {
  for (const Index e : mesh.vertex_edge) require_edge(e, mesh);
  for (const HalfEdge& edge : mesh.edges) {
    require_vertex(edge.vertex, mesh);
    for (const Index e : {edge.next, edge.prev, edge.twin}) require_edge(e, mesh);
    require_face(edge.face, mesh);
  }
  for (const Face& face : mesh.faces) require_edge(face.edge, mesh);
}

/// build_half_edge_mesh(). The issue is only described and drawn, which checks its indices.
inline void check_indices(const MeshBuild& build, const std::span<const Vec3>& /*vertices*/,
                          const std::span<const Triangle>& /*triangles*/) {
  check_indices(build.mesh);
}

/// merge_coplanar_faces()
inline void check_indices(const HalfEdgeMesh& merged, const HalfEdgeMesh& /*mesh*/,
                          const Real& /*tolerance*/) {
  check_indices(merged);
}

/// support_brute_force()
inline void check_indices(const Support& support, const std::span<const Vec3>& vertices,
                          const Vec3& /*direction*/) {
  require_element(support.vertex, vertices.size(), "vertex");
}

/// hill_climb()
inline void check_indices(const Support& support, const HalfEdgeMesh& mesh,
                          const Vec3& /*direction*/, const Index& /*start*/,
                          std::vector<Index>* const& path) {
  require_vertex(support.vertex, mesh);
  if (path == nullptr) return;
  for (const Index v : *path) require_vertex(v, mesh);
}

/// support()
inline void check_indices(const SupportPoint& support, const PosedShape& body,
                          const Vec3& /*direction*/, const Index& /*start*/) {
  require_vertex(support.vertex, body.mesh());
}

inline void check_indices(const AxisFeature& feature) {
  if (feature > AxisFeature::Edges) throw cereal::Exception("its kind of axis is unknown");
}

/// query_face_directions()
inline void check_indices(const FaceQuery& query, const PosedShape& a, const PosedShape& b) {
  require_face(query.face, a.mesh());
  require_vertex(query.vertex, b.mesh());
}

/// query_edge_directions()
inline void check_indices(const EdgeQuery& query, const PosedShape& a, const PosedShape& b) {
  require_edge(query.edge_a, a.mesh());
  require_edge(query.edge_b, b.mesh());
}

/// find_separating_axis()
inline void check_indices(const SeparatingAxis& axis, const PosedShape& a, const PosedShape& b,
                          const SeparatingAxis& /*hint*/, const Real& /*margin*/) {
  check_indices(axis.feature);
  check_indices(axis.face_a, a, b);
  check_indices(axis.face_b, b, a);
  check_indices(axis.edges, a, b);
}

/// find_incident_face()
inline void check_indices(const Index& face, const PosedShape& body, const Index& /*vertex*/,
                          const Vec3& /*reference_normal*/) {
  require_face(face, body.mesh());
}

inline void check_indices(const FeatureId& feature) {
  if (feature.kind() > FeatureId::Kind::Edges) {
    throw cereal::Exception("a feature id has an unknown kind");
  }
}

template <int Capacity, class... Arguments>
void check_indices(const StaticVector<ContactPoint, Capacity>& points, const Arguments&...) {
  for (const ContactPoint& point : points) check_indices(point.feature);
}

template <class... Arguments>
void check_indices(const Manifold& manifold, const Arguments&... /*arguments*/) {
  check_indices(manifold.reference);
  check_indices(manifold.points);
}
/// @}

/// The bodies of a constraint stay as they were: no contact solver has a reason to change them.
/// @throws cereal::Exception for another number of constraints
/// @{
template <class Stored>
void keep_bodies(const Stored& /*was*/, Stored& /*is no constraint*/) {}

inline void keep_bodies(const ContactConstraint& was, ContactConstraint& is) {
  is.body_a = was.body_a;
  is.body_b = was.body_b;
}

inline void keep_bodies(const std::vector<ContactConstraint>& was,
                        std::vector<ContactConstraint>& is) {
  if (is.size() != was.size()) throw cereal::Exception("it has another number of constraints");
  for (std::size_t i = 0; i < was.size(); ++i) keep_bodies(was[i], is[i]);
}
/// @}

}  // namespace cs550::grader
