// The world as a container: collision filters, removal of bodies, ids, events, copies.

#include "cs550/world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "cs550/diagnostics.hpp"
#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

Real height(const World& world, BodyId id) { return world.body(id).pose.position.z(); }

bool same_pair(const ContactEvent& event, BodyId a, BodyId b) {
  return (event.a == a && event.b == b) || (event.a == b && event.b == a);
}

TEST(World, RefusesBodiesThatMakeNoSense) {
  World world;
  const auto refused = [&world](auto change) {
    BodyDef def = body_at(unit_box(), Vec3::Zero());
    change(def);
    EXPECT_THROW(world.add_body(def), std::invalid_argument);
    EXPECT_EQ(world.body_count(), 0);
  };
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  refused([](BodyDef& def) { def.shape = nullptr; });
  refused([nan](BodyDef& def) { def.pose.position.x() = nan; });
  refused([nan](BodyDef& def) { def.linear_velocity.y() = nan; });
  refused([](BodyDef& def) { def.pose.orientation = Quat(0, 0, 0, 0); });
  refused([](BodyDef& def) { def.mass = Real(0); });
  refused([](BodyDef& def) { def.mass = Real(1e-39); });  // 1/I is beyond the range of Real
  refused([](BodyDef& def) {                              // I is
    def.shape = box_shape(Vec3::Constant(Real(100)));
    def.mass = Real(3e38);
  });
  refused([](BodyDef& def) { def.mass = Real(1e19); });
  refused([](BodyDef& def) { def.linear_velocity.x() = Real(1e17); });
  refused([](BodyDef& def) { def.angular_velocity.z() = Real(1e20); });
  refused([](BodyDef& def) {
    def.kind = BodyKind::Kinematic;
    def.angular_velocity.z() = Real(1e22);
  });
  refused([](BodyDef& def) { def.density = -1; });
  refused([nan](BodyDef& def) {
    def.mass = Real(1);
    def.density = nan;
  });
  refused([nan](BodyDef& def) { def.friction = nan; });
  refused(
      [](BodyDef& def) { def.friction = Real(1e20); });  // its square is beyond the range of Real
  refused([](BodyDef& def) { def.restitution = Real(1.5); });
}

// Its kinetic energy is finite, 1.8e23 J, but the square of its momentum is not.
TEST(World, NamesTheLimitThatTheMomentumOfABodyExceeds) {
  World world;
  BodyDef def = body_at(unit_box(), Vec3::Zero());
  def.mass = Real(1e15);
  def.linear_velocity = {19'000, 0, 0};
  try {
    world.add_body(def);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& refusal) {
    EXPECT_STREQ(refusal.what(),
                 "a body needs velocities with which its kinetic energy and the square of its "
                 "momentum are finite");
  }
}

/// How fast a box still is (m/s) that began to slide over a floor at 10 m/s, two seconds ago.
Real speed_after_sliding(Real mass) {
  World world;
  world.add_body(floor_body(50));
  BodyDef def = body_at(unit_box(), {0, 0, Real(0.5)});
  def.mass = mass;
  def.linear_velocity = {10, 0, 0};
  const BodyId box = world.add_body(def);
  run(world, 120);
  EXPECT_TRUE(is_finite(world)) << mass << " kg";
  return world.body(box).linear_velocity.norm();
}

// μ·g·t = 0.6 · 9.81 m/s² · 2 s is more than 10 m/s.
TEST(World, FrictionStopsTheLightestAndTheHeaviestBody) {
  // 1/m + r²/I = (1 + 6 · 0.75)/m is at most 1e18/kg.
  for (const Real mass : {Real(5.6e-18), Real(1), Real(1e15)}) {
    EXPECT_LT(speed_after_sliding(mass), Real(1e-3)) << mass << " kg";
  }
  for (const Real mass : {Real(5.4e-18), Real(1.1e15)}) {
    EXPECT_THROW(speed_after_sliding(mass), std::invalid_argument) << mass << " kg";
  }
}

// Its energy is finite, though the square of its momentum is not.
TEST(World, TheEnergyOfAHeavyBodyIsThatOfItsVelocity) {
  RigidBody body = make_dynamic_body(Real(1e15), Mat3::Identity(), {});
  set_velocity(body, {20'000, 0, 0}, Vec3::Zero());
  EXPECT_NEAR(kinetic_energy(body) / Real(2e23), 1, 1e-6);
}

// 7 kg over the volume, times the volume, are 7.0000005 kg.
TEST(World, ABodyHasExactlyTheMassOfItsDefinition) {
  World world;
  BodyDef def = body_at(box_shape(Vec3::Constant(Real(0.3))), Vec3::Zero());
  def.mass = Real(7);
  EXPECT_EQ(world.body(world.add_body(def)).mass, Real(7));
}

TEST(World, ABodyIsMadeFromTheDefinitionOfAnother) {
  World world;
  BodyId last = world.add_body(body_at(unit_box(), Vec3::Zero()));
  for (int i = 0; i < 20; ++i) last = world.add_body(world.definition(last));  // arrays grow
  EXPECT_EQ(world.body_count(), 21);
  EXPECT_EQ(world.shape(last), world.shape(world.id_at(0)));
}

TEST(World, AnOrientationThatIsNearlyOfUnitLengthIsNormalised) {
  World world;
  BodyDef def = body_at(unit_box(), Vec3::Zero(), BodyKind::Static);
  def.pose.orientation.coeffs() *= Real(1.0009);
  EXPECT_NEAR(world.body(world.add_body(def)).pose.orientation.norm(), 1, 1e-6);
}

TEST(World, KinematicBodyCarriesAndIsNotPushed) {
  World world;
  BodyDef lift = body_at(box_shape({2, 2, Real(0.5)}), {0, 0, Real(-0.5)}, BodyKind::Kinematic);
  lift.linear_velocity = {0, 0, 1};
  const BodyId carrier = world.add_body(lift);
  const BodyId rider = world.add_body(body_at(unit_box(), {0, 0, Real(0.5)}));
  run(world, 120);
  // Two seconds at 1 m/s; the rider's weight does not slow the lift.
  EXPECT_NEAR(height(world, carrier), 1.5, 1e-3);
  EXPECT_NEAR(height(world, rider), 2.5, 0.01) << "it rides on top, within the slop";
}

TEST(World, KinematicBodyTurnsAtItsOwnRate) {
  World world;
  BodyDef wheel = body_at(unit_box(), Vec3::Zero(), BodyKind::Kinematic);
  wheel.angular_velocity = {0, 0, pi / 2};
  const BodyId id = world.add_body(wheel);
  run(world, 60);
  EXPECT_LT((world.body(id).pose.rotate(Vec3::UnitX()) - Vec3::UnitY()).norm(), 1e-4F);
}

TEST(World, FilterNeedsBothSidesToAgree) {
  const struct {
    CollisionFilter box;
    CollisionFilter floor;
    bool touches;
  } cases[] = {
      {{1, 0xffffffffU}, {1, 0xffffffffU}, true}, {{2, 1}, {1, 2}, true},
      {{2, 0xffffffffU}, {1, 1}, false},  // the floor ignores the box
      {{2, 2}, {1, 0xffffffffU}, false},  // the box ignores the floor
      {{1, 0}, {1, 0xffffffffU}, false},
  };
  for (const auto& each : cases) {
    World world;
    BodyDef floor = floor_body();
    floor.filter = each.floor;
    world.add_body(floor);
    BodyDef box = body_at(unit_box(), {0, 0, Real(0.5)});
    box.filter = each.box;
    const BodyId id = world.add_body(box);
    run(world, 60);
    EXPECT_EQ(height(world, id) > 0, each.touches);
    EXPECT_EQ(world.contacts().empty(), !each.touches);
  }
}

TEST(World, TellsWhenBodiesBeginAndCeaseToTouch) {
  World world;
  const BodyId floor = world.add_body(floor_body());
  const BodyId box = world.add_body(body_at(unit_box(), {0, 0, 1}));
  int began = 0;
  int ended = 0;
  const auto count = [&](int steps) {
    for (int i = 0; i < steps; ++i) {
      world.step(step_length);
      for (const ContactEvent& event : world.began()) began += same_pair(event, floor, box);
      for (const ContactEvent& event : world.ended()) ended += same_pair(event, floor, box);
    }
  };
  count(6);  // 0.1 s: it has fallen 5 of 50 cm
  EXPECT_EQ(began, 0);
  count(60);
  EXPECT_EQ(began, 1) << "landed once, e = 0";
  EXPECT_EQ(ended, 0);
  apply_impulse(world.body(box), world.body(box).mass * Vec3(0, 0, 3),
                world.body(box).pose.position);
  count(10);
  EXPECT_EQ(ended, 1) << "thrown up at 3 m/s";
}

TEST(World, RemovedBodyEndsItsContacts) {
  World world;
  const BodyId floor = world.add_body(floor_body());
  const BodyId lower = world.add_body(body_at(unit_box(), {0, 0, Real(0.5)}));
  const BodyId upper = world.add_body(body_at(unit_box(), {0, 0, Real(1.5)}));
  run(world, 30);
  world.remove_body(lower);
  EXPECT_FALSE(world.is_alive(lower));
  EXPECT_EQ(world.body_count(), 2);
  world.step(step_length);
  const auto ended = world.ended();
  EXPECT_EQ(ended.size(), 2U);
  for (const BodyId other : {floor, upper}) {
    EXPECT_TRUE(std::any_of(ended.begin(), ended.end(), [&](const ContactEvent& event) {
      return same_pair(event, lower, other);
    }));
  }
  run(world, 60);
  EXPECT_NEAR(height(world, upper), 0.5, 0.01) << "the upper box has fallen onto the floor";
}

TEST(World, ARedefinedBodyKeepsItsIdAndBeginsItsContactsAnew) {
  World world;
  world.settings().sleeping = true;
  const BodyId floor = world.add_body(floor_body());
  const BodyId lower = world.add_body(body_at(unit_box(), {0, 0, Real(0.5)}));
  const BodyId upper = world.add_body(body_at(unit_box(), {0, 0, Real(1.5)}));
  run(world, 90);
  ASSERT_TRUE(world.body(lower).asleep && world.body(upper).asleep);

  BodyDef flat = world.definition(lower);
  flat.shape = box_shape({Real(0.5), Real(0.5), Real(0.25)});
  flat.pose.position.z() = Real(0.25);
  flat.mass = Real(100);
  world.redefine_body(lower, flat);
  EXPECT_EQ(world.body_count(), 3);
  world.step(step_length);
  const auto ended = world.ended();
  EXPECT_EQ(ended.size(), 2U);
  EXPECT_TRUE(std::any_of(ended.begin(), ended.end(), [&](const ContactEvent& event) {
    return same_pair(event, floor, lower);
  }));
  EXPECT_EQ(world.body(lower).mass, Real(100));
  run(world, 60);
  EXPECT_NEAR(height(world, upper), 1, 0.01) << "it has fallen onto the flat body";

  flat.kind = BodyKind::Static;
  flat.pose.position.z() = 3;
  world.redefine_body(lower, flat);
  run(world, 60);
  EXPECT_EQ(height(world, lower), 3) << "it no longer moves";
  EXPECT_NEAR(height(world, upper), 0.5, 0.01);

  flat.filter.mask = 0;
  flat.kind = BodyKind::Dynamic;
  world.redefine_body(lower, flat);
  run(world, 60);
  EXPECT_LT(height(world, lower), 0) << "nothing stops it";

  flat.restitution = 2;
  EXPECT_THROW(world.redefine_body(lower, flat), std::invalid_argument);
  EXPECT_EQ(world.definition(lower).restitution, 0);
  world.remove_body(lower);
  EXPECT_THROW(world.redefine_body(lower, floor_body()), std::invalid_argument);
}

// A box on a slope of 20° rests with a friction of 0.6 and slides with one of 0.1.
TEST(World, ARedefinedFrictionActs) {
  const Quat slope(Eigen::AngleAxis<Real>(Real(0.35), Vec3::UnitY()));
  World world;
  BodyDef ground = floor_body();
  ground.pose = {slope * ground.pose.position, slope};
  world.add_body(ground);
  BodyDef def = body_at(unit_box(), Vec3::Zero());
  def.pose = {slope * Vec3(0, 0, Real(0.5)), slope};
  const BodyId box = world.add_body(def);
  run(world, 60);
  EXPECT_LT(world.body(box).linear_velocity.norm(), Real(1e-3));
  def.pose = world.body(box).pose;
  def.friction = Real(0.1) * Real(0.1) / Real(0.6);  // a pair has the geometric mean
  world.redefine_body(box, def);
  run(world, 60);
  const double expected = 9.81 * (std::sin(0.35) - 0.1 * std::cos(0.35));
  EXPECT_NEAR(world.body(box).linear_velocity.norm(), expected, 0.02 * expected);
}

TEST(World, IdNamesOneBodyOnly) {
  World world;
  const BodyId first = world.add_body(body_at(unit_box(), Vec3::Zero()));
  world.remove_body(first);
  const BodyId empty_slot = world.id_at(first.index);
  const BodyId second = world.add_body(body_at(unit_box(), {5, 0, 0}));
  EXPECT_EQ(first.index, second.index) << "the place is used again";
  EXPECT_FALSE(first == second);
  EXPECT_FALSE(empty_slot == second) << "an id that was not alive names no later body";
  world.remove_body(first);  // the id is out of date: no effect
  EXPECT_TRUE(world.is_alive(second));
  EXPECT_FALSE(world.is_alive({}));
  EXPECT_FALSE(world.is_alive({77, 0}));
}

TEST(World, RefusesTheIdOfABodyThatIsNotAlive) {
  World world;
  const BodyId removed = world.add_body(body_at(unit_box(), Vec3::Zero()));
  world.remove_body(removed);
  world.add_body(body_at(unit_box(), {5, 0, 0}));  // at the same index
  for (const BodyId id : {removed, BodyId{}, BodyId{77, 0}}) {
    EXPECT_THROW(world.body(id), std::invalid_argument);
    EXPECT_THROW(std::as_const(world).body(id), std::invalid_argument);
    EXPECT_THROW(world.shape(id), std::invalid_argument);
    EXPECT_THROW(world.definition(id), std::invalid_argument);
    EXPECT_THROW(world.posed_shape(id), std::invalid_argument);
  }
  EXPECT_THROW(world.id_at(-1), std::invalid_argument);
  EXPECT_THROW(world.id_at(1), std::invalid_argument);
}

TEST(World, AStaticBodyHasNoVelocityWhateverIsWritten) {
  World world;
  const BodyId floor = world.add_body(floor_body());
  const BodyId box = world.add_body(body_at(unit_box(), {0, 0, Real(0.5)}));
  world.body(floor).linear_velocity = {1, 0, 0};
  run(world, 30);
  EXPECT_NEAR(world.body(box).pose.position.x(), 0, 1e-3);
}

TEST(World, BodiesComeAndGoAtAnyTime) {
  Random random(11);
  World world;
  world.settings().check_stages = true;
  world.add_body(floor_body());
  std::vector<BodyId> alive;
  for (int step = 0; step < 600; ++step) {
    if (step % 5 == 0 && alive.size() < 30) {
      const Real x = random.real(-2, 2);
      const Real y = random.real(-2, 2);
      alive.push_back(world.add_body(body_at(unit_box(), {x, y, 4})));
    }
    if (step % 7 == 0 && alive.size() > 10) {
      const auto chosen = alive.begin() + random.integer(0, static_cast<int>(alive.size()) - 1);
      world.remove_body(*chosen);
      alive.erase(chosen);
    }
    world.step(step_length);
    ASSERT_TRUE(world.problems().empty()) << world.problems()[0].message << " at step " << step;
    for (const Contact& contact : world.contacts()) {
      ASSERT_LT(contact.body_a, contact.body_b);
      ASSERT_TRUE(world.is_alive(world.id_at(contact.body_a)));
      ASSERT_TRUE(world.is_alive(world.id_at(contact.body_b)));
    }
  }
  EXPECT_EQ(world.body_count(), static_cast<int>(alive.size()) + 1);
  for (const BodyId id : alive) EXPECT_GT(height(world, id), 0) << "nobody fell through the floor";
}

TEST(World, SeveralBodiesRemovedAtOnceLeaveWhatRemovalOneByOneLeaves) {
  for (const bool sleeping : {false, true}) {
    World pile = falling_hulls(40, 15);
    pile.settings().sleeping = sleeping;
    run(pile, sleeping ? 900 : 100);
    const std::vector<BodyId> leaving = pile.query({{-1, -1, -1}, {1, 1, 1}});
    ASSERT_GE(leaving.size(), 5U) << "the floor, and hulls near the middle";
    EXPECT_EQ(pile.stats().asleep > 0, sleeping);

    World one_by_one = pile;
    for (auto id = leaving.rbegin(); id != leaving.rend(); ++id) one_by_one.remove_body(*id);
    World at_once = pile;
    std::vector<BodyId> ids = leaving;
    ids.insert(ids.end(), leaving.begin(), leaving.end());
    ids.push_back({});
    ids.push_back({leaving[0].index, leaving[0].generation + 1});
    at_once.remove_bodies(ids);
    EXPECT_EQ(at_once.body_count(), pile.body_count() - static_cast<int>(leaving.size()));
    EXPECT_EQ(at_once.contacts().size(), one_by_one.contacts().size());

    for (World* world : {&one_by_one, &at_once}) {
      EXPECT_EQ(world->add_body(floor_body()).index, leaving[0].index) << "the lowest free one";
    }
    for (int step = 0; step < 60; ++step) {
      one_by_one.step(step_length);
      at_once.step(step_length);
      ASSERT_EQ(at_once.state_hash(), one_by_one.state_hash()) << "step " << step;
      ASSERT_EQ(at_once.ended().size(), one_by_one.ended().size());
      if (step == 0) {
        EXPECT_GT(at_once.ended().size(), 5U);
      }
    }
  }
}

TEST(World, CopyContinuesToTheLastBit) {
  World world = falling_hulls(12, 12);
  run(world, 100);
  World copy = world;
  World assigned;
  assigned = world;
  ASSERT_GT(world.stats().contacts, 5);
  for (int step = 0; step < 100; ++step) {
    for (World* each : {&world, &copy, &assigned}) each->step(step_length);
    ASSERT_EQ(copy.state_hash(), world.state_hash()) << "step " << step;
    ASSERT_EQ(assigned.state_hash(), world.state_hash()) << "step " << step;
  }
}

TEST(World, AWorldThatWasMovedFromCanBeAssignedTo) {
  World world = falling_hulls(3, 12);
  World moved = std::move(world);
  world = moved;  // NOLINT(bugprone-use-after-move): this is what is tested
  run(world, 10);
  run(moved, 10);
  EXPECT_EQ(world.state_hash(), moved.state_hash());
}

TEST(World, RestoredStateRepeatsWhatHappened) {
  World world = falling_hulls(8, 13);
  run(world, 60);
  const World saved = world;
  run(world, 60);
  const std::uint64_t first_time = world.state_hash();
  EXPECT_NE(first_time, saved.state_hash());
  world = saved;
  run(world, 60);
  EXPECT_EQ(world.state_hash(), first_time);
}

TEST(World, SameSceneGivesTheSameBits) {
  World first = falling_hulls(10, 14);
  World second = falling_hulls(10, 14);
  run(first, 200);
  run(second, 200);
  EXPECT_EQ(first.state_hash(), second.state_hash());
}

TEST(World, ForcesActForOneStep) {
  WorldSettings weightless;
  weightless.gravity.setZero();
  World world(weightless);
  const BodyId id = world.add_body(body_at(unit_box(), Vec3::Zero()));
  const Real mass = world.body(id).mass;
  add_force(world.body(id), {mass * 60, 0, 0}, world.body(id).pose.position);
  run(world, 3);
  // 60 m/s² for one step of 1/60 s.
  EXPECT_NEAR(world.body(id).linear_velocity.x(), 1, 1e-5);
}

}  // namespace
}  // namespace cs550
