/// Values of the contract after a round trip, member by member. Comparing their bytes would not notice a member
/// that neither the writer nor the reader knows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include "serialisation/bytes.hpp"
#include "serialisation/contract_archive.hpp"

namespace cs550::test {
namespace {

// All members of a type. A new member breaks the build here.

auto members(const HalfEdge& edge) {
  const auto& [vertex, next, prev, twin, face] = edge;
  return std::tie(vertex, next, prev, twin, face);
}

auto members(const Plane& plane) {
  const auto& [normal, offset] = plane;
  return std::tie(normal, offset);
}

auto members(const Face& face) {
  const auto& [edge, plane] = face;
  return std::tie(edge, plane);
}

auto members(const HalfEdgeMesh& mesh) {
  const auto& [vertices, vertex_edge, edges, faces] = mesh;
  return std::tie(vertices, vertex_edge, edges, faces);
}

auto members(const MeshIssue& issue) {
  const auto& [error, triangle, other_triangle, vertex, edge] = issue;
  return std::tie(error, triangle, other_triangle, vertex, edge);
}

auto members(const MeshBuild& build) {
  const auto& [mesh, issue] = build;
  return std::tie(mesh, issue);
}

auto members(const PlaneBlock& block) {
  const auto& [x, y, z, offset] = block;
  return std::tie(x, y, z, offset);
}

auto members(const Bounds& bounds) {
  const auto& [lower, upper] = bounds;
  return std::tie(lower, upper);
}

auto members(const ConvexShape& shape) {
  const auto& [mesh, plane_blocks, volume, unit_inertia, source_origin, bounds, radius,
               inner_radius, smallest_half_extent] = shape;
  return std::tie(mesh, plane_blocks, volume, unit_inertia, source_origin, bounds, radius,
                  inner_radius, smallest_half_extent);
}

auto members(const ContactPoint& point) {
  const auto& [anchor_a, anchor_b, separation, feature, normal_impulse, tangent_impulse] = point;
  return std::tie(anchor_a, anchor_b, separation, feature, normal_impulse, tangent_impulse);
}

auto members(const Manifold& manifold) {
  const auto& [normal, tangent, reference, points] = manifold;
  return std::tie(normal, tangent, reference, points);
}

auto members(const Contact& contact) {
  const auto& [body_a, body_b, manifold, friction, restitution] = contact;
  return std::tie(body_a, body_b, manifold, friction, restitution);
}

auto members(const WorldSettings& settings) {
  const auto& [gravity, length_unit, substeps, iterations, relax_iterations, pass_order, solver,
               contact_model, rotation, warm_starting, temporal_coherence, sleeping, threads,
               adaptive_threads, contact_hertz, contact_damping_ratio, baumgarte, slop,
               max_push_speed, restitution_threshold, restitution_iterations, over_relaxation,
               rolling_resistance, check_stages, audit_momentum] = settings;
  return std::tie(gravity, length_unit, substeps, iterations, relax_iterations, pass_order, solver,
                  contact_model, rotation, warm_starting, temporal_coherence, sleeping, threads,
                  adaptive_threads, contact_hertz, contact_damping_ratio, baumgarte, slop,
                  max_push_speed, restitution_threshold, restitution_iterations, over_relaxation,
                  rolling_resistance, check_stages, audit_momentum);
}

template <class T>
concept HasMembers = requires(const T& value) {
  members(value);
};

template <class T>
bool same(const T& x, const T& y);
template <class T>
bool same(const std::vector<T>& x, const std::vector<T>& y);
template <class T, int Capacity>
bool same(const StaticVector<T, Capacity>& x, const StaticVector<T, Capacity>& y);

template <class... T>
bool all_same(const std::tuple<const T&...>& x, const std::tuple<const T&...>& y) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return (same(std::get<I>(x), std::get<I>(y)) && ...);
  }
  (std::index_sequence_for<T...>());
}

template <class List>
bool same_items(const List& x, const List& y) {
  return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                    [](const auto& a, const auto& b) { return same(a, b); });
}

template <class T>
bool same(const T& x, const T& y) {
  if constexpr (HasMembers<T>) {
    return all_same(members(x), members(y));
  } else {
    return x == y;
  }
}
template <class T>
bool same(const std::vector<T>& x, const std::vector<T>& y) {
  return same_items(x, y);
}
template <class T, int Capacity>
bool same(const StaticVector<T, Capacity>& x, const StaticVector<T, Capacity>& y) {
  return same_items(x, y);
}

/// Calls `check(index, member of x, member of y)` for each member.
template <class T, class Check>
void for_members(const T& x, const T& y, const Check& check) {
  const auto of_x = members(x);
  const auto of_y = members(y);
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (check(I, std::get<I>(of_x), std::get<I>(of_y)), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<decltype(of_x)>>());
}

/// Every member differs from its default: one that is lost would be noticed.
template <class T>
void expect_filled(const T& value) {
  if constexpr (HasMembers<T>) {
    for_members(value, T(), [](std::size_t i, const auto& member, const auto& plain) {
      EXPECT_FALSE(same(member, plain)) << "member " << i << " has its default";
      expect_filled(member);
    });
  }
}

template <class T>
void expect_members_sent(const T& value) {
  expect_filled(value);
  const T received = serialisation::from_bytes<T>(serialisation::to_bytes(value));
  for_members(received, value, [](std::size_t i, const auto& got, const auto& sent) {
    EXPECT_TRUE(same(got, sent)) << "member " << i;
  });
}

HalfEdgeMesh filled_mesh() {
  HalfEdgeMesh mesh;
  mesh.vertices = {{1, 2, 3}, {4, 5, 6}};
  mesh.vertex_edge = {7, 8, 9};
  mesh.edges = {{10, 11, 12, 13, 14}, {15, 16, 17, 18, 19}};
  mesh.faces = {{20, {{21, 22, 23}, 24}}};
  return mesh;
}

ContactPoint filled_point(Real first) {
  ContactPoint point;
  point.anchor_a = {first, first + 1, first + 2};
  point.anchor_b = {first + 3, first + 4, first + 5};
  point.separation = first + 6;
  point.feature.bits = static_cast<std::uint32_t>(first) + 7;
  point.normal_impulse = first + 8;
  point.tangent_impulse = {first + 9, first + 10};
  return point;
}

Manifold filled_manifold() {
  Manifold manifold;
  manifold.normal = {1, 2, 3};
  manifold.tangent = {4, 5, 6};
  manifold.reference = AxisFeature::Edges;
  manifold.points.push_back(filled_point(10));
  manifold.points.push_back(filled_point(30));
  return manifold;
}

TEST(Members, OfAManifoldAreSent) {
  expect_filled(filled_point(10));
  expect_members_sent(filled_manifold());
}

TEST(Members, OfAContactAreSent) {
  Contact contact;
  contact.body_a = 1;
  contact.body_b = 2;
  contact.manifold = filled_manifold();
  contact.friction = 3;
  contact.restitution = 4;
  expect_members_sent(contact);
}

TEST(Members, OfAMeshBuildAreSent) {
  expect_filled(filled_mesh().edges[0]);
  expect_filled(filled_mesh().faces[0]);
  MeshBuild build;
  build.mesh = filled_mesh();
  build.issue.error = MeshError::OpenEdge;
  build.issue.triangle = 1;
  build.issue.other_triangle = 2;
  build.issue.vertex = 3;
  build.issue.edge = {4, 5};
  expect_members_sent(build);
}

TEST(Members, OfAConvexShapeAreSent) {
  ConvexShape shape;
  shape.mesh = filled_mesh();
  PlaneBlock& block = shape.plane_blocks.emplace_back();
  block.x.fill(1);
  block.y.fill(2);
  block.z.fill(3);
  block.offset.fill(4);
  shape.volume = 5;
  shape.unit_inertia << 6, 7, 8, 9, 10, 11, 12, 13, 14;
  shape.source_origin = {15, 16, 17};
  shape.bounds = {{18, 19, 20}, {21, 22, 23}};
  shape.radius = 24;
  shape.inner_radius = 25;
  shape.smallest_half_extent = 26;
  expect_filled(block);
  expect_members_sent(shape);
}

TEST(Members, OfWorldSettingsAreSent) {
  WorldSettings settings;
  settings.gravity = {1, 2, 3};
  settings.length_unit = 4;
  settings.substeps = 5;
  settings.iterations = 6;
  settings.relax_iterations = 7;
  settings.pass_order = PassOrder::BackAndForth;
  settings.solver = SolverKind::Naive;
  settings.contact_model = ContactModel::Baumgarte;
  settings.rotation = RotationMethod::Explicit;
  settings.warm_starting = false;
  settings.temporal_coherence = false;
  settings.sleeping = true;
  settings.threads = 8;
  settings.adaptive_threads = false;
  settings.contact_hertz = 9;
  settings.contact_damping_ratio = 10;
  settings.baumgarte = 11;
  settings.slop = 12;
  settings.max_push_speed = 13;
  settings.restitution_threshold = 14;
  settings.restitution_iterations = 15;
  settings.over_relaxation = 16;
  settings.rolling_resistance = 17;
  settings.check_stages = true;
  settings.audit_momentum = true;
  expect_members_sent(settings);
}

}  // namespace
}  // namespace cs550::test
