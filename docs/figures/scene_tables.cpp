#include <algorithm>
#include <cmath>

#include "cs550/diagnostics.hpp"
#include "cs550/scene.hpp"
#include "figure.hpp"
#include "stack.hpp"

namespace cs550::book {
namespace {

constexpr Real h = Real(1) / 60;

const RigidBody& last_body(const World& world) { return world.bodies().back(); }

/// time, height lost by the top of ten boxes (m): naive with 1, 4, 20 passes, then the constraint solver
void naive_stack(std::ostream& out) {
  World worlds[] = {
      stack_of_boxes(10, SolverKind::Naive, 1), stack_of_boxes(10, SolverKind::Naive, 4),
      stack_of_boxes(10, SolverKind::Naive, 20), stack_of_boxes(10, SolverKind::Constraint)};
  for (int i = 0; i <= 180; ++i) {
    out << i / 60.0;
    for (World& world : worlds) {
      out << ' ' << 9.5 - static_cast<double>(last_body(world).pose.position.z());
      world.step(h);
    }
    out << '\n';
  }
}

/// time, height lost by the top of ten boxes (mm): without warm starting, as it is
void tower(std::ostream& out) {
  World cold = stack_of_boxes(10, SolverKind::Constraint);
  cold.settings().warm_starting = false;
  World warm = stack_of_boxes(10, SolverKind::Constraint);
  for (int i = 0; i <= 600; ++i) {
    out << i / 60.0;
    for (World* world : {&cold, &warm}) {
      out << ' ' << 1000 * (9.5 - static_cast<double>(last_body(*world).pose.position.z()));
      world->step(h);
    }
    out << '\n';
  }
}

World one_box(const Pose& pose, Real friction, Real restitution) {
  World world;
  add_floor(world, friction);
  add_box(world, Vec3::Constant(Real(0.5)), pose, friction, restitution);
  return world;
}

/// time, height above the floor (mm) of a box that begins 5 cm inside: Baumgarte, soft
void recovery(std::ostream& out) {
  const World box = one_box({Vec3(0, 0, Real(0.45)), Quat::Identity()}, Real(0.6), 0);
  World worlds[] = {box, box};
  worlds[0].settings().contact_model = ContactModel::Baumgarte;
  worlds[0].settings().substeps = 1;
  worlds[0].settings().iterations = 8;
  for (int i = 0; i <= 60; ++i) {
    out << i / 60.0;
    for (World& world : worlds) {
      out << ' ' << 1000 * (static_cast<double>(last_body(world).pose.position.z()) - 0.5);
      world.step(h);
    }
    out << '\n';
  }
}

/// angle (°), speed after 1 s: closed form, measured. The slope is laid flat and gravity is turned.
void incline(std::ostream& out) {
  constexpr double mu = 0.5, g = 9.81;
  for (int degrees = 0; degrees <= 44; degrees += 2) {
    const double slope = degrees * M_PI / 180;
    World world = one_box({Vec3(0, 0, Real(0.5)), Quat::Identity()}, Real(mu), 0);
    world.settings().gravity = {static_cast<Real>(g * std::sin(slope)), 0,
                                static_cast<Real>(-g * std::cos(slope))};
    for (int i = 0; i < 60; ++i) world.step(h);
    out << degrees << ' ' << std::max(0.0, g * (std::sin(slope) - mu * std::cos(slope))) << ' '
        << last_body(world).linear_velocity.norm() << '\n';
  }
}

/// drop height (m), first rebound over e²·height: e = 1, 0.8, 0.5
void rebounds(std::ostream& out) {
  for (int k = 0; k < 64; ++k) {
    const double drop = 5 + 0.005 * k;
    out << drop;
    for (const double e : {1.0, 0.8, 0.5}) {
      World world = one_box({Vec3(0, 0, static_cast<Real>(drop + 0.5)), Quat::Identity()},
                            Real(0.6), static_cast<Real>(e));
      double apex = 0;
      bool rising = false;
      for (int i = 0; i < 180; ++i) {
        world.step(h);
        const RigidBody& body = last_body(world);
        rising = rising || body.linear_velocity.z() > 0;
        if (rising) apex = std::max(apex, static_cast<double>(body.pose.position.z()) - 0.5);
        if (rising && body.linear_velocity.z() < Real(-0.3)) break;
      }
      out << ' ' << apex / (e * e * drop);
    }
    out << '\n';
  }
}

double invariant_of(const World& world) {
  return energy(world, h / static_cast<Real>(world.settings().substeps)).invariant;
}

constexpr const char* shown_scenes[] = {"bounce", "dominoes", "stack10", "wall"};

/// time, invariant energy over its start, one column for each of shown_scenes
void energy_scenes(std::ostream& out) {
  std::vector<World> worlds;
  std::vector<double> start;
  for (const char* name : shown_scenes) {
    worlds.push_back(make_world(find_scene(name).scene));
    start.push_back(invariant_of(worlds.back()));
  }
  for (int i = 0; i <= 240; ++i) {
    out << i / 60.0;
    for (std::size_t k = 0; k < worlds.size(); ++k) {
      out << ' ' << invariant_of(worlds[k]) / start[k];
      worlds[k].step(h);
    }
    out << '\n';
  }
}

/// scene, milliseconds per step of each stage
void stages(std::ostream& out) {
  constexpr int steps = 120;
  out << "scene";
  for (int stage = 0; stage < stage_count; ++stage)
    out << " \"" << to_string(static_cast<Stage>(stage)) << '"';
  out << '\n';
  for (const char* name : {"pyramid20", "wall", "box_pile", "hull_pile"}) {
    World world = make_world(find_scene(name).scene);
    std::array<double, stage_count> sum{};
    for (int i = 0; i < steps; ++i) {
      world.step(h);
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += world.stats().seconds[k];
    }
    std::string label = name;
    std::replace(label.begin(), label.end(), '_', ' ');
    out << '"' << label << "\\n" << world.body_count() << " bodies\"";
    for (const double seconds : sum) out << ' ' << 1000 * seconds / steps;
    out << '\n';
  }
}

}  // namespace

std::vector<Table> scene_tables() {
  return {{"naive_stack", naive_stack},
          {"tower", tower},
          {"recovery", recovery},
          {"incline", incline},
          {"rebounds", rebounds},
          {"energy_scenes", energy_scenes},
          {"stages", stages}};
}

}  // namespace cs550::book
