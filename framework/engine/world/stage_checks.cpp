#include <algorithm>
#include <cmath>
#include <vector>

#include "cs550/clipping.hpp"
#include "engine/islands/rest.hpp"
#include "engine/pairs/axis_promise.hpp"
#include "engine/pairs/near_pairs.hpp"
#include "engine/pairs/temporal_coherence.hpp"
#include "engine/world/stages.hpp"

namespace cs550 {

namespace {

/// Of a query, relative to the sizes of both bodies: several roundings to float.
constexpr Real query_rounding = Real(1e-6);

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

/// The impulses of a step that is undone may not be numbers, and the next one would begin with them.
/// @param restored of each body, whether it is
void forget_impulses(PairList& pairs, const std::vector<char>& restored) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const PairSummary& pair = pairs.summaries[i];
    if (!restored[pair.body_a] && !restored[pair.body_b]) continue;
    for (ContactPoint& point : pairs.contacts[i].manifold.points) {
      point.normal_impulse = 0;
      point.tangent_impulse.setZero();
    }
    pairs.impulse_energy[i] = 0;
  }
}

}  // namespace

void check_bodies(WorldState& world, Stage stage, int lab) {
  std::vector<char> reported;
  const auto is_reported = [&](std::size_t body) {
    if (reported.empty()) {
      reported.resize(world.bodies.size());
      for (const StageProblem& problem : world.problems) {
        if (problem.body != no_index) reported[problem.body] = 1;
      }
    }
    return reported[body] != 0;
  };
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const char* promise = broken_promise(world.bodies[i]);
    if (promise == nullptr || is_reported(i)) continue;
    report(world, stage, lab, static_cast<Index>(i), promise);
  }
}

void restore_broken_bodies(WorldState& world) {
  std::vector<char> restored;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    RigidBody& body = world.bodies[i];
    if (broken_promise(body) == nullptr) continue;
    body = world.bodies_before[i];
    body.force.setZero();  // which have acted
    body.torque.setZero();
    body.asleep = false;  // a body that sleeps keeps its promises
    // It seems to rest, since it begins each step where it began the last one.
    if (world.settings.sleeping) restart_window(body, world.sleeping.bodies[i]);
    restored.resize(world.bodies.size());
    restored[i] = 1;
  }
  if (restored.empty()) return;
  forget_impulses(world.pairs, restored);
  if (world.settings.audit_momentum) world.audit = world.audit_before;
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
