/// Integration of lab 1, per body and substep: momenta, velocities, poses, velocities.
#include "benchmarks/stages/stage.hpp"
#include "cs550/integration.hpp"
#include "cs550/primitives.hpp"
#include "cs550/world.hpp"
#include "engine/body_sweeps.hpp"
#include "helpers/random.hpp"

namespace cs550::bench {
namespace {

constexpr int brick_count = 1000;
constexpr Real substep = Real(1) / 480;

std::vector<RigidBody> turning_bricks() {
  World world;
  const TriangleSoup soup = box_soup({Real(0.5), Real(0.3), Real(0.4)});
  BodyDef brick;
  brick.shape = make_shape(soup.vertices, soup.triangles).shape;
  test::Random random(9);
  for (int i = 0; i < brick_count; ++i) {
    brick.pose.orientation = random.orientation();
    brick.angular_velocity = random.unit_vector();
    world.add_body(brick);
  }
  return {world.bodies().begin(), world.bodies().end()};
}

void integrate(benchmark::State& state, RotationMethod method) {
  std::vector<RigidBody> bodies = turning_bricks();
  for ([[maybe_unused]] auto _ : state) {
    for (RigidBody& body : bodies) {
      integrate_momentum(body, substep);
      refresh_velocity(body);
      integrate_pose(body, substep, method);
      refresh_velocity(body);
    }
    benchmark::DoNotOptimize(bodies.data());
  }
}

/// The same as the world does it.
void sweep_over_bodies(benchmark::State& state) {
  std::vector<RigidBody> bodies = turning_bricks();
  std::vector<SolverBody> solver_bodies(bodies.size());
  for ([[maybe_unused]] auto _ : state) {
    integrate_momenta(bodies, substep);
    integrate_poses(bodies, solver_bodies, substep, RotationMethod::ImplicitMidpoint);
    benchmark::DoNotOptimize(bodies.data());
  }
}

}  // namespace

std::vector<Stage> integration_stages() {
  return {{"integration/explicit", 0, brick_count,
           [](auto& state) { integrate(state, RotationMethod::Explicit); }},
          {"integration/midpoint", 0, brick_count,
           [](auto& state) { integrate(state, RotationMethod::ImplicitMidpoint); }},
          {"integration/sweeps", 0, brick_count, sweep_over_bodies}};
}

}  // namespace cs550::bench
