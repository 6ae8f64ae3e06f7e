// The sweeps of a substep over all bodies: the engine's kernels must leave the bits that the
// functions of lab 1 leave, body by body.
#include "engine/body_sweeps.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "helpers/random.hpp"

namespace cs550::test {
namespace {

struct Bodies {
  std::vector<RigidBody> bodies;
  std::vector<SolverBody> solver_bodies;
};

/// Between 1e-6 and 1e2 rad/s, each decade as often: the resting, the falling and the lost.
Vec3 random_spin(Random& random) {
  return std::pow(Real(10), random.real(-6, 2)) * random.unit_vector();
}

RigidBody random_body(Random& random) {
  const Pose pose{random.point_in_box({5, 5, 5}), random.orientation()};
  const Real kind = random.real(0, 1);
  if (kind < Real(0.1)) return make_immovable_body(BodyKind::Static, pose);
  RigidBody body;
  if (kind < Real(0.2)) {
    body = make_immovable_body(BodyKind::Kinematic, pose);
  } else {
    const Real thinness = random.real(0, 1) < Real(0.2) ? Real(1e-3) : Real(0.5);
    const Vec3 inertia(random.real(1, 2), random.real(1, 2), random.real(thinness, 1));
    body = make_dynamic_body(random.real(1, 10), inertia.asDiagonal(), pose);
  }
  set_velocity(body, random.real(0, 5) * random.unit_vector(),
               random.real(0, 1) < Real(0.1) ? Vec3(0, 0, 0) : random_spin(random));
  body.force = random.real(0, 100) * random.unit_vector();
  body.torque = random.real(0, 10) * random.unit_vector();
  refresh_velocity(body);
  return body;
}

Bodies random_bodies(Random& random) {
  Bodies all;
  for (Index i = random.integer(0, 30); i > 0; --i) {
    all.bodies.push_back(random_body(random));
    const RigidBody& body = all.bodies.back();
    SolverBody solver_body;
    solver_body.v = body.linear_velocity;
    solver_body.w = body.angular_velocity;
    if (random.real(0, 1) < Real(0.7)) {
      solver_body.v += random.real(0, 1) * random.unit_vector();
      solver_body.w += random.real(0, 1) * random.unit_vector();
    }
    all.solver_bodies.push_back(solver_body);
  }
  return all;
}

template <class Numbers>
bool same_bits(const Numbers& x, const Numbers& y) {
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (std::bit_cast<std::uint32_t>(x.data()[i]) != std::bit_cast<std::uint32_t>(y.data()[i])) {
      return false;
    }
  }
  return true;
}

void expect_same(const Bodies& swept, const Bodies& in_turn) {
  for (std::size_t i = 0; i < in_turn.bodies.size(); ++i) {
    SCOPED_TRACE("body " + std::to_string(i));
    const RigidBody& body = swept.bodies[i];
    const RigidBody& expected = in_turn.bodies[i];
    EXPECT_TRUE(same_bits(body.pose.position, expected.pose.position));
    EXPECT_TRUE(same_bits(body.pose.orientation.coeffs(), expected.pose.orientation.coeffs()));
    EXPECT_TRUE(same_bits(body.linear_momentum, expected.linear_momentum));
    EXPECT_TRUE(same_bits(body.angular_momentum, expected.angular_momentum));
    EXPECT_TRUE(same_bits(body.linear_velocity, expected.linear_velocity));
    EXPECT_TRUE(same_bits(body.angular_velocity, expected.angular_velocity));
    EXPECT_TRUE(same_bits(body.world_inverse_inertia, expected.world_inverse_inertia));
    const SolverBody& solver_body = swept.solver_bodies[i];
    const SolverBody& expected_solver_body = in_turn.solver_bodies[i];
    EXPECT_TRUE(same_bits(solver_body.delta_position, expected_solver_body.delta_position));
    EXPECT_TRUE(same_bits(solver_body.delta_rotation, expected_solver_body.delta_rotation));
  }
}

/// Runs a sweep on random bodies, and what it stands for on each of them in turn.
template <class Sweep, class Visit>
void compare(const Sweep& sweep, const Visit& visit) {
  for (std::uint32_t seed = 1; seed <= 400 && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Bodies swept = random_bodies(random);
    Bodies in_turn = swept;
    sweep(swept);
    for (std::size_t i = 0; i < in_turn.bodies.size(); ++i) {
      visit(in_turn.bodies[i], in_turn.solver_bodies[i]);
    }
    expect_same(swept, in_turn);
  }
}

constexpr Real substep = Real(1) / 480;

TEST(BodySweeps, IntegrateMomentaLikeLab1) {
  compare([](Bodies& all) { integrate_momenta(all.bodies, substep); },
          [](RigidBody& body, SolverBody&) {
            if (body.kind != BodyKind::Dynamic) return;
            integrate_momentum(body, substep);
            refresh_velocity(body);
          });
}

TEST(BodySweeps, AddTheChangesOfMomentumThatVelocitiesShow) {
  compare([](Bodies& all) { add_momentum_changes(all.bodies, all.solver_bodies); },
          [](RigidBody& body, const SolverBody& solver_body) {
            const Vec3 dv = solver_body.v - body.linear_velocity;
            const Vec3 dw = solver_body.w - body.angular_velocity;
            if (body.kind != BodyKind::Dynamic || (dv.isZero(0) && dw.isZero(0))) return;
            body.linear_momentum += body.mass * dv;
            body.angular_momentum += body.pose.rotate(body.inertia * body.pose.unrotate(dw));
            refresh_velocity(body);
          });
}

TEST(BodySweeps, IntegratePosesLikeLab1) {
  for (const RotationMethod method : {RotationMethod::ImplicitMidpoint, RotationMethod::Explicit}) {
    for (const Real h : {substep, Real(1) / 60}) {
      compare([&](Bodies& all) { integrate_poses(all.bodies, all.solver_bodies, h, method); },
              [&](RigidBody& body, SolverBody& solver_body) {
                if (body.kind == BodyKind::Static) return;
                solver_body.delta_position += h * body.linear_velocity;
                solver_body.delta_rotation += h * body.angular_velocity;
                turn_and_move(body, h, method);
              });
    }
  }
}

}  // namespace
}  // namespace cs550::test
