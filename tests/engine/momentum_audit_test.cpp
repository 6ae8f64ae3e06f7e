// The momentum error of a run: of a step that adds momentum from nowhere, and of rounding that loses an impulse.

#include <gtest/gtest.h>

#include "engine/test_bodies.hpp"
#include "engine/world/stages.hpp"

namespace cs550 {
namespace {

using namespace test;

/// One audited step without substeps, in which a body of 6 kg gets 1 N·s from nowhere.
MomentumAudit audit_of_a_gift(bool audited, Real gravity, Real h) {
  WorldState world;
  world.settings.audit_momentum = audited;
  world.settings.gravity = {0, 0, -gravity};
  RigidBody& body = world.bodies.emplace_back();
  body.mass = 6;
  body.linear_momentum = {9, 0, 0};
  world.bodies.push_back(make_immovable_body(BodyKind::Kinematic, {}));
  world.bodies.back().linear_momentum = {100, 0, 0};  // which does not count
  begin_audit(world);
  world.bodies.front().linear_momentum.x() += 1;
  end_audit(world, h);
  return world.audit;
}

/// World::momentum_error() is their ratio.
TEST(MomentumAudit, ReportsMomentumFromNowhere) {
  const MomentumAudit weightless = audit_of_a_gift(true, 0, 1);
  EXPECT_EQ(weightless.unexplained, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(weightless.largest_sum, 10) << "|P|";
  const MomentumAudit heavy = audit_of_a_gift(true, 10, Real(0.5));
  EXPECT_EQ(heavy.unexplained, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(heavy.largest_sum, 40) << "|P| + m·g·h";
  const MomentumAudit unwatched = audit_of_a_gift(false, 0, 1);
  EXPECT_EQ(unwatched.unexplained.norm(), 0);
  EXPECT_EQ(unwatched.largest_sum, 0);
}

/// Two steps count against the larger of their momenta, not the sum.
TEST(MomentumAudit, IsRelativeToTheLargestMomentaOfAStep) {
  WorldState world;
  world.settings.audit_momentum = true;
  world.settings.gravity.setZero();
  Vec3& momentum = world.bodies.emplace_back().linear_momentum;
  for (const Real gift : {Real(8), Real(-5)}) {
    begin_audit(world);
    momentum.x() += gift;
    end_audit(world, 1);
  }
  EXPECT_EQ(world.audit.unexplained, Eigen::Vector3d(3, 0, 0));
  EXPECT_EQ(world.audit.largest_sum, 8);
}

/// At 2²⁴ N·s floats are 2 N·s apart. Adding 0.5 N·s leaves such a momentum as it is, and after 64 steps
/// 32 N·s are missing.
TEST(MomentumAudit, CountsWhatRoundingLoses) {
  constexpr Real h = Real(1) / 64;
  constexpr Real start = 1 << 24;
  for (const bool audited : {true, false}) {
    World world;
    world.settings().audit_momentum = audited;
    world.settings().gravity.setZero();
    world.settings().substeps = 1;
    BodyDef def = body_at(unit_box(), Vec3::Zero());
    def.mass = Real(1 << 20);
    def.linear_velocity = {16, 0, 0};
    const BodyId id = world.add_body(def);
    ASSERT_EQ(world.body(id).linear_momentum.x(), start);
    for (int step = 0; step < 64; ++step) {
      world.body(id).force.x() = Real(0.5) / h;
      world.step(h);
    }
    EXPECT_EQ(world.body(id).linear_momentum.x(), start);
    EXPECT_EQ(world.momentum_error(), audited ? 32.0 / (1 << 24) : 0.0);
  }
}

}  // namespace
}  // namespace cs550
