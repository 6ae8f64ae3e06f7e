#include <algorithm>
#include <cmath>

#include "cs550/clipping.hpp"
#include "engine/pairs/near_pairs.hpp"
#include "engine/pairs/temporal_coherence.hpp"
#include "engine/world/stages.hpp"

namespace cs550 {

namespace {

/// The rounding of a normalised vector or quaternion, with a margin for one product of such.
constexpr Real unit_tolerance = Real(1e-3);

/// Of a query, relative to the sizes of both bodies: several roundings to float.
constexpr Real query_rounding = Real(1e-6);

bool is_unit(const Vec3& v) { return std::abs(v.norm() - 1) < unit_tolerance; }

void report(WorldState& world, Stage stage, int lab, Index body, const std::string& promise) {
  world.problems.push_back({stage, lab, body, world.step_count,
                            "stage " + std::string(to_string(stage)) + " (lab " +
                                std::to_string(lab) + "), body " + std::to_string(body) +
                                ", step " + std::to_string(world.step_count) + ": " + promise});
}

/// The promise that lab 1 broke for this body, or nullptr.
const char* broken_promise(const RigidBody& body) {
  if (!body.pose.position.allFinite() || !body.linear_momentum.allFinite()) {
    return "position or linear momentum is not finite";
  }
  if (!body.pose.orientation.coeffs().allFinite() || !body.angular_momentum.allFinite()) {
    return "orientation or angular momentum is not finite";
  }
  if (!body.linear_velocity.allFinite() || !body.angular_velocity.allFinite()) {
    return "a velocity is not finite";
  }
  if (std::abs(body.pose.orientation.norm() - 1) > unit_tolerance) {
    return "the orientation is not a unit quaternion";
  }
  return nullptr;
}

bool in_range(Index index, Index count) { return index >= 0 && index < count; }

bool in_range(const FaceQuery& query, const HalfEdgeMesh& faces_of,
              const HalfEdgeMesh& vertices_of) {
  return !query || (in_range(query.face, faces_of.face_count()) &&
                    in_range(query.vertex, vertices_of.vertex_count()));
}

/// The promise that lab 4 broke for this axis, or nullptr.
const char* broken_promise(const SeparatingAxis& axis, const HalfEdgeMesh& a,
                           const HalfEdgeMesh& b) {
  if (!std::isfinite(axis.separation)) return "the separation is not finite";
  if (!is_unit(axis.axis)) return "the axis is not a unit vector";
  if (!in_range(axis.face_a, a, b) || !in_range(axis.face_b, b, a)) {
    return "a face query names a face or vertex that does not exist";
  }
  if (axis.edges && (!in_range(axis.edges.edge_a, a.edge_count()) ||
                     !in_range(axis.edges.edge_b, b.edge_count()))) {
    return "the edge query names an edge that does not exist";
  }
  return nullptr;
}

/// The promise that lab 5 broke for this manifold, or nullptr.
const char* broken_promise(const Manifold& manifold) {
  if (manifold.points.empty()) return nullptr;
  if (!is_unit(manifold.normal)) return "the normal is not a unit vector";
  if (!is_unit(manifold.tangent) ||
      std::abs(manifold.normal.dot(manifold.tangent)) > unit_tolerance) {
    return "the tangent is not a unit vector perpendicular to the normal";
  }
  for (const ContactPoint& point : manifold.points) {
    if (!point.anchor_a.allFinite() || !point.anchor_b.allFinite() ||
        !std::isfinite(point.separation)) {
      return "a contact point is not finite";
    }
  }
  return nullptr;
}

/// What a fresh query finds wrong with a kept answer, or nullptr.
const char* broken_promise(const WorldState& world, std::size_t pair, Real margin) {
  const Contact& contact = world.pairs.contacts[pair];
  const PosedShape a = world.posed_shape(contact.body_a);
  const PosedShape b = world.posed_shape(contact.body_b);
  const Real separation_then = world.pairs.axes[pair].separation;
  const Real separation_now = find_separating_axis(a, b, {}, margin).separation;
  // Depths are compared. The separation of bodies apart jumps where edges become parallel.
  const Real change = std::min(Real(0), separation_now) - std::min(Real(0), separation_then);
  const Real radius = std::min(a.shape->radius, b.shape->radius);
  const Real size = a.shape->radius + b.shape->radius;
  const Real tolerance =
      (kept_motion + 3 * tie_tolerance + 2 * parallel_sine) * radius + query_rounding * size;
  if (std::abs(change) <= tolerance) return nullptr;
  return contact.manifold.points.empty() ? "bodies that overlap were kept apart"
                                         : "a contact was kept although the bodies moved";
}

}  // namespace

void check_bodies(WorldState& world, Stage stage, int lab) {
  const auto is_reported = [&](Index body) {
    return std::any_of(world.problems.begin(), world.problems.end(),
                       [&](const StageProblem& problem) { return problem.body == body; });
  };
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const char* promise = broken_promise(world.bodies[i]);
    const auto body = static_cast<Index>(i);
    if (promise != nullptr && !is_reported(body)) report(world, stage, lab, body, promise);
  }
}

void restore_broken_bodies(WorldState& world) {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    RigidBody& body = world.bodies[i];
    if (broken_promise(body) == nullptr) continue;
    body = world.bodies_before[i];
    body.force.setZero();  // which have acted
    body.torque.setZero();
    body.asleep = false;  // a body that sleeps keeps its promises
  }
}

void check_axes(WorldState& world) {
  for (std::size_t i = 0; i < world.pairs.size(); ++i) {
    SeparatingAxis& axis = world.pairs.axes[i];
    if (axis.feature == AxisFeature::None) continue;
    const Contact& contact = world.pairs.contacts[i];
    const char* promise = broken_promise(axis, world.posed_shape(contact.body_a).mesh(),
                                         world.posed_shape(contact.body_b).mesh());
    if (promise == nullptr) continue;
    report(world, Stage::Collide, 4, contact.body_a, promise);
    axis = {};
  }
}

void check_kept_answers(WorldState& world, Real h) {
  for (std::size_t i = 0; i < world.pairs.size(); ++i) {
    if (world.pairs.answers[i] == PairAnswer::Queried) continue;
    const Contact& contact = world.pairs.contacts[i];
    const Real margin = contact_margin(world, contact.body_a, contact.body_b, h);
    const char* promise = broken_promise(world, i, margin);
    if (promise != nullptr) report(world, Stage::Collide, 4, contact.body_a, promise);
  }
}

void check_manifolds(WorldState& world) {
  for (std::size_t i = 0; i < world.pairs.size(); ++i) {
    Contact& contact = world.pairs.contacts[i];
    const char* promise = broken_promise(contact.manifold);
    if (promise == nullptr) continue;
    report(world, Stage::Manifolds, 5, contact.body_a, promise);
    contact.manifold.points.clear();
    world.pairs.summarise(i);
  }
}

}  // namespace cs550
