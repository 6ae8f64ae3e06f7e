#pragma once
/// @file contract_archive.hpp
/// How cereal archives the values of the contract. Each function lists its type's members in a
/// structured binding, so a new member breaks the build here until it is archived.

#include <cereal/cereal.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/tuple.hpp>
#include <cereal/types/vector.hpp>

#include "cs550/clipping.hpp"
#include "cs550/constraint_solver.hpp"
#include "cs550/hill_climbing.hpp"
#include "cs550/integration.hpp"
#include "cs550/world.hpp"

namespace Eigen {

template <class Archive, class Scalar, int Rows, int Columns, int Options>
void serialize(Archive& archive, Matrix<Scalar, Rows, Columns, Options>& matrix) {
  static_assert(Rows > 0 && Columns > 0, "only types of fixed size");
  archive.numbers(matrix.data(), static_cast<std::size_t>(matrix.size()));
}

template <class Archive, class Scalar, int Options>
void serialize(Archive& archive, Quaternion<Scalar, Options>& q) {
  archive(q.coeffs());
}

}  // namespace Eigen

namespace cs550 {

template <class Archive>
void serialize(Archive& archive, Plane& plane) {
  auto& [normal, offset] = plane;
  archive(normal, offset);
}

template <class Archive>
void serialize(Archive& archive, Pose& pose) {
  auto& [position, orientation] = pose;
  archive(position, orientation);
}

template <class Archive>
void serialize(Archive& archive, Bounds& bounds) {
  auto& [lower, upper] = bounds;
  archive(lower, upper);
}

template <class Archive>
void serialize(Archive& archive, RigidBody& body) {
  auto& [kind, asleep, mass, inverse_mass, inertia, inverse_inertia, pose, p, l, force, torque, v,
         w, world_inverse_inertia] = body;
  archive(kind, asleep, mass, inverse_mass, inertia, inverse_inertia, pose, p, l, force, torque, v,
          w, world_inverse_inertia);
}

template <class Archive>
void serialize(Archive& archive, HalfEdge& half_edge) {
  auto& [vertex, next, prev, twin, face] = half_edge;
  archive(vertex, next, prev, twin, face);
}

template <class Archive>
void serialize(Archive& archive, Face& face) {
  auto& [edge, plane] = face;
  archive(edge, plane);
}

template <class Archive>
void serialize(Archive& archive, HalfEdgeMesh& mesh) {
  auto& [vertices, vertex_edge, edges, faces] = mesh;
  archive(vertices, vertex_edge, edges, faces);
}

template <class Archive>
void serialize(Archive& archive, PlaneBlock& block) {
  auto& [x, y, z, offset] = block;
  archive(x, y, z, offset);
}

template <class Archive>
void serialize(Archive& archive, ConvexShape& shape) {
  auto& [mesh, plane_blocks, volume, unit_inertia, source_origin, bounds, radius, inner_radius,
         smallest_half_extent] = shape;
  archive(mesh, plane_blocks, volume, unit_inertia, source_origin, bounds, radius, inner_radius,
          smallest_half_extent);
}

template <class Archive>
void serialize(Archive& archive, MeshIssue& issue) {
  auto& [error, triangle, other_triangle, vertex, edge] = issue;
  archive(error, triangle, other_triangle, vertex, edge);
}

template <class Archive>
void serialize(Archive& archive, MeshBuild& build) {
  auto& [mesh, issue] = build;
  archive(mesh, issue);
}

template <class Archive>
void serialize(Archive& archive, Support& support) {
  auto& [vertex, visited] = support;
  archive(vertex, visited);
}

template <class Archive>
void serialize(Archive& archive, SupportPoint& support) {
  auto& [vertex, point] = support;
  archive(vertex, point);
}

template <class Archive>
void serialize(Archive& archive, FaceQuery& query) {
  auto& [face, vertex, separation] = query;
  archive(face, vertex, separation);
}

template <class Archive>
void serialize(Archive& archive, EdgeQuery& query) {
  auto& [edge_a, edge_b, axis, separation] = query;
  archive(edge_a, edge_b, axis, separation);
}

template <class Archive>
void serialize(Archive& archive, SeparatingAxis& separating_axis) {
  auto& [feature, axis, separation, face_a, face_b, edges] = separating_axis;
  archive(feature, axis, separation, face_a, face_b, edges);
}

template <class Archive>
void serialize(Archive& archive, ClipEdge& clip_edge) {
  auto& [source, edge] = clip_edge;
  archive(source, edge);
}

template <class Archive>
void serialize(Archive& archive, ClipVertex& vertex) {
  auto& [point, in, out] = vertex;
  archive(point, in, out);
}

template <class Archive>
void serialize(Archive& archive, FeatureId& feature) {
  auto& [bits] = feature;
  archive(bits);
}

template <class Archive>
void serialize(Archive& archive, ContactPoint& point) {
  auto& [anchor_a, anchor_b, separation, feature, normal_impulse, tangent_impulse] = point;
  archive(anchor_a, anchor_b, separation, feature, normal_impulse, tangent_impulse);
}

template <class Archive>
void serialize(Archive& archive, Manifold& manifold) {
  auto& [normal, tangent, reference, points] = manifold;
  archive(normal, tangent, reference, points);
}

template <class Archive>
void serialize(Archive& archive, Contact& contact) {
  auto& [body_a, body_b, manifold, friction, restitution] = contact;
  archive(body_a, body_b, manifold, friction, restitution);
}

template <class Archive>
void serialize(Archive& archive, SolverBody& body) {
  auto& [v, w, inverse_mass, world_inverse_inertia, delta_position, delta_rotation] = body;
  archive(v, w, inverse_mass, world_inverse_inertia, delta_position, delta_rotation);
}

template <class Archive>
void serialize(Archive& archive, Softness& softness) {
  auto& [bias_rate, mass_scale, impulse_scale] = softness;
  archive(bias_rate, mass_scale, impulse_scale);
}

template <class Archive>
void serialize(Archive& archive, ContactConstraint& constraint) {
  auto& [body_a, body_b, n, u, r_a, r_b, separation, friction, restitution, normal_mass,
         tangent_mass, softness, approach_velocity, impact_handled, normal_impulse,
         tangent_impulse] = constraint;
  archive(body_a, body_b, n, u, r_a, r_b, separation, friction, restitution, normal_mass,
          tangent_mass, softness, approach_velocity, impact_handled, normal_impulse,
          tangent_impulse);
}

template <class Archive>
void serialize(Archive& archive, ContactJacobian& jacobian) {
  auto& [linear_a, angular_a, linear_b, angular_b] = jacobian;
  archive(linear_a, angular_a, linear_b, angular_b);
}

template <class Archive>
void serialize(Archive& archive, ContactStep& step) {
  auto& [h, use_bias, backwards, model, soft, soft_static, baumgarte, slop, max_push_speed,
         restitution_threshold, restitution_iterations] = step;
  archive(h, use_bias, backwards, model, soft, soft_static, baumgarte, slop, max_push_speed,
          restitution_threshold, restitution_iterations);
}

template <class Archive>
void serialize(Archive& archive, ContactBias& bias) {
  auto& [velocity, mass_scale, impulse_scale] = bias;
  archive(velocity, mass_scale, impulse_scale);
}

template <class Archive>
void serialize(Archive& archive, WorldSettings& settings) {
  auto& [gravity, length_unit, substeps, iterations, relax_iterations, pass_order, solver,
         contact_model, rotation, warm_starting, temporal_coherence, sleeping, threads,
         adaptive_threads, contact_hertz, contact_damping_ratio, baumgarte, slop, max_push_speed,
         restitution_threshold, restitution_iterations, over_relaxation, rolling_resistance,
         check_stages, audit_momentum] = settings;
  archive(gravity, length_unit, substeps, iterations, relax_iterations, pass_order, solver,
          contact_model, rotation, warm_starting, temporal_coherence, sleeping, threads,
          adaptive_threads, contact_hertz, contact_damping_ratio, baumgarte, slop, max_push_speed,
          restitution_threshold, restitution_iterations, over_relaxation, rolling_resistance,
          check_stages, audit_momentum);
}

template <class Archive, class T, int Capacity>
void save(Archive& archive, const StaticVector<T, Capacity>& items) {
  archive(items.size());
  for (const T& item : items) archive(item);
}

template <class Archive, class T, int Capacity>
void load(Archive& archive, StaticVector<T, Capacity>& items) {
  int size = 0;
  archive(size);
  if (size < 0 || size > Capacity) throw cereal::Exception("more items than there is room for");
  items.clear();
  for (int i = 0; i < size; ++i) {
    T item;
    archive(item);
    items.push_back(item);
  }
}

}  // namespace cs550
