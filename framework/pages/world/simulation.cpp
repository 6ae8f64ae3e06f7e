#include "pages/world/simulation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cs550/broad_phase.hpp"
#include "cs550/not_implemented.hpp"
#include "pages/labs/shapes.hpp"

namespace cs550::pages {
namespace {

constexpr Real pull_hertz = 2;         ///< of the spring between body and mouse, for any mass
constexpr Real pull_damping = 1;       ///< critical: the body comes to rest at the mouse
constexpr Real thrown_density = 2000;  ///< kg/m³

/// The acceleration of a point per force at it, times the mass of the body: 1 − m·[r]×·I⁻¹·[r]×.
/// @param r from the centre of mass, world (m)
Mat3 response(const RigidBody& body, const Vec3& r) {
  Mat3 cross;
  cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return Mat3::Identity() - cross * (body.mass * body.world_inverse_inertia) * cross;
}

std::vector<Bounds> inner_nodes(const AabbTree& tree) {
  std::vector<Bounds> boxes;
  for (const AabbTree::Node& node : tree.nodes()) {
    if (node.height > 0) boxes.push_back(node.bounds);
  }
  return boxes;
}

std::vector<std::string> messages(std::span<const StageProblem> problems) {
  std::vector<std::string> result;
  for (const StageProblem& problem : problems) {
    const std::string message = std::string(to_string(problem.stage)) + ": " + problem.message;
    if (std::find(result.begin(), result.end(), message) == result.end()) {
      result.push_back(message);
    }
  }
  return result;
}

}  // namespace

WorldFrame Simulation::serve(const WorldRequest& request) {
  WorldFrame frame;
  if (!request.scene.empty()) build(request.scene, frame);
  if (!world_) throw std::logic_error("no scene has been built");
  if (request.settings) world_->settings() = *request.settings;
  if (request.thrown) throw_box(*request.thrown);
  for (int i = 0; i < request.steps && lost_.empty(); ++i) {
    pull(request.pull);
    step();
    frame.samples.push_back(sample());
  }
  describe(frame);
  return frame;
}

/// A step that loses the finite state is taken back, and the world stands still from then on.
void Simulation::step() {
  const World before = *world_;
  world_->step(h_);
  if (is_finite(*world_)) {
    stepped_ = world_->bodies().size();
    return;
  }
  lost_ = find_broken_stages(before, h_);
  *world_ = before;
}

void Simulation::build(const std::string& name, WorldFrame& frame) {
  const SceneResult found = find_scene(name);
  if (!found) throw std::runtime_error(found.error);
  Scene scene = found.scene;
  scene.settings.sleeping = true;
  world_.emplace(make_world(scene));
  h_ = scene.h;
  stepped_ = 0;
  lost_.clear();
  sent_meshes_.clear();
  frame.scene = {scene.name,       scene.title,    scene.description,
                 scene.body_names, scene.settings, scene.h};
}

/// Any scene can be thrown at, so the box needs no lab's code.
void Simulation::throw_box(const Throw& thrown) {
  BodyDef def;
  def.shape = recorded_shape(Box, std::sqrt(Real(3)) / 2 * thrown.side);
  def.density = thrown_density;
  def.pose.position = thrown.position;
  def.linear_velocity = thrown.velocity;
  def.angular_velocity = {1, 2, 3};
  world_->add_body(def);
}

/// A damped spring. Its force is that of the end of the step (implicit Euler), for the mass that the pulled
/// point has: a corner yields more than the centre. So it is stable for every point and every step.
void Simulation::pull(const Pull& pull) {
  if (pull.body == no_index || !world_->is_alive(world_->id_at(pull.body))) return;
  RigidBody& body = world_->body(world_->id_at(pull.body));
  if (body.kind != BodyKind::Dynamic) return;
  const Vec3 point = body.pose.to_world(pull.anchor);
  const Vec3 r = point - body.pose.position;
  const Vec3 velocity = body.linear_velocity + body.angular_velocity.cross(r);
  const Real omega = 2 * pi * pull_hertz;
  const Vec3 displacement = pull.target - point - h_ * velocity;
  const Vec3 acceleration = (omega * omega * displacement - 2 * pull_damping * omega * velocity) /
                            (1 + 2 * pull_damping * omega * h_ + omega * omega * h_ * h_);
  const Vec3 force = body.mass * response(body, r).inverse() * acceleration;
  try {
    add_force(body, force, point);
  } catch (const NotImplemented&) {
    // The next step reports which function of lab 1 is missing.
  }
}

StepSample Simulation::sample() const {
  const StepStats& stats = world_->stats();
  const int substeps = std::max(1, world_->settings().substeps);
  const Energy sum = energy(*world_, h_ / static_cast<Real>(substeps));
  StepSample sample;
  sample.time = world_->time();
  sample.kinetic = sum.kinetic;
  sample.potential = sum.potential;
  sample.linear = linear_momentum(*world_).cast<Real>();
  sample.angular = angular_momentum(*world_).cast<Real>();
  sample.penetration = -stats.deepest_separation;
  sample.contacts = stats.contacts;
  sample.points = stats.points;
  sample.seconds = stats.seconds;
  return sample;
}

Index Simulation::mesh_number(const ShapePtr& shape, WorldFrame& frame) {
  const auto [entry, is_new] = sent_meshes_.emplace(shape, static_cast<Index>(sent_meshes_.size()));
  if (is_new) frame.meshes.push_back(shape->mesh);
  return entry->second;
}

void Simulation::describe(WorldFrame& frame) {
  frame.bodies.assign(world_->bodies().begin(), world_->bodies().end());
  for (std::size_t i = stepped_; i < frame.bodies.size(); ++i) {
    RigidBody& body = frame.bodies[i];
    if (body.kind != BodyKind::Dynamic) continue;
    const auto [linear, angular] = velocities_from_momenta(body);
    body.linear_velocity = linear;
    body.angular_velocity = angular;
  }
  frame.contacts.assign(world_->contacts().begin(), world_->contacts().end());
  const std::span<const Contact> asleep = world_->sleeping_contacts();
  frame.contacts.insert(frame.contacts.end(), asleep.begin(), asleep.end());
  for (Index i = 0; i < static_cast<Index>(frame.bodies.size()); ++i) {
    const BodyId id = world_->id_at(i);
    const bool alive = world_->is_alive(id);
    frame.is_alive.push_back(static_cast<char>(alive));
    frame.mesh_of_body.push_back(alive ? mesh_number(world_->shape(id), frame) : no_index);
    frame.bounds.push_back(alive ? world_bounds(world_->posed_shape(id)) : Bounds());
  }
  frame.tree = inner_nodes(world_->broad_phase());
  frame.problems = messages(lost_.empty() ? world_->problems() : std::span(lost_));
  frame.is_lost = !lost_.empty();
  frame.step = world_->step_count();
  frame.time = world_->time();
}

}  // namespace cs550::pages
