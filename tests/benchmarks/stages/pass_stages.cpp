// Passes of lab 7 over the constraints of many cubes, in groups as the engine solves them and one
// by one.
#include <algorithm>
#include <vector>

#include "benchmarks/stages/stage.hpp"
#include "engine/contacts/contact_passes.hpp"

namespace cs550::bench {
namespace {

struct Bricks {
  std::vector<SolverBody> bodies;
  std::vector<ContactConstraint> constraints;
  ContactStep step;
};

/// `count` unit cubes, each on the ground with four corners, in the groups of the world. The ground
/// is the last body.
Bricks cubes_on_the_ground(int count) {
  Bricks bricks;
  bricks.step.h = Real(1) / 480;
  bricks.step.soft = bricks.step.soft_static = soft_contact(30, 4, bricks.step.h);
  bricks.bodies.resize(count + 1);
  for (int i = 0; i < count; ++i) {
    SolverBody& body = bricks.bodies[i];
    body.inverse_mass = 1;
    body.world_inverse_inertia = 6 * Mat3::Identity();
  }
  constexpr auto lanes = static_cast<int>(lane_count);
  const Vec3 corners[] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}};
  for (int first = 0; first < count; first += lanes) {
    for (const Vec3& corner : corners) {
      for (int i = first; i < std::min(first + lanes, count); ++i) {
        ContactConstraint constraint;
        constraint.body_a = count;
        constraint.body_b = i;
        constraint.n = Vec3::UnitZ();
        constraint.u = Vec3::UnitX();
        constraint.r_b = Real(0.5) * corner;
        constraint.friction = Real(0.6);
        bricks.constraints.push_back(constraint);
      }
    }
  }
  prepare_contacts(bricks.constraints, bricks.bodies, bricks.step);
  return bricks;
}

void push_down(Bricks& bricks) {
  for (SolverBody& body : bricks.bodies) {
    if (body.inverse_mass > 0) body.v += Vec3(Real(0.001), 0, Real(-0.02));
  }
}

void pass_at_once(benchmark::State& state, int cubes) {
  Bricks bricks = cubes_on_the_ground(cubes);
  ConstraintMirror mirror;
  for ([[maybe_unused]] auto _ : state) {
    push_down(bricks);
    run_passes(mirror, bricks.constraints, bricks.bodies, bricks.step, {.count = 1});
    benchmark::DoNotOptimize(bricks.bodies.data());
  }
}

void pass_one_by_one(benchmark::State& state, int cubes) {
  Bricks bricks = cubes_on_the_ground(cubes);
  for ([[maybe_unused]] auto _ : state) {
    push_down(bricks);
    for (ContactConstraint& constraint : bricks.constraints) {
      SolverBody& a = bricks.bodies[constraint.body_a];
      SolverBody& b = bricks.bodies[constraint.body_b];
      solve_normal(constraint, a, b, bricks.step);
      solve_friction(constraint, a, b);
    }
    benchmark::DoNotOptimize(bricks.bodies.data());
  }
}

}  // namespace

std::vector<Stage> pass_stages() {
  constexpr int corners = 4;
  std::vector<Stage> stages;
  const std::pair<const char*, void (*)(benchmark::State&, int)> families[] = {
      {"pass/at_once", pass_at_once}, {"pass/one_by_one", pass_one_by_one}};
  for (const auto& [family, run] : families) {
    for (const int cubes : {4, 64, 512}) {
      stages.push_back({member(family, corners * cubes), 0, static_cast<double>(corners * cubes),
                        [run = run, cubes](benchmark::State& state) { run(state, cubes); }});
    }
  }
  return stages;
}

}  // namespace cs550::bench
