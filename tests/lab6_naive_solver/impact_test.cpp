// L6.3: the impulse of one contact without restitution.
#include <cs550/graded_test.hpp>

#include "helpers/story.hpp"
#include "lab6_naive_solver/pictures.hpp"

namespace cs550::test {
namespace {

constexpr const char* gathers_impulses =
    "the constraint gathers its impulses: add to normal_impulse, do not overwrite it";

Story with_causes(Story story) {
  return story.likely("j pushes B along n and A against it: −j·n to A, +j·n to B")
      .likely("j = −(1 + e)·v_n·m_e: positive, for v_n is negative when approaching")
      .likely("an impulse off the centre of mass turns the body: each body has its own r")
      .likely("change the bodies of the span, not copies of them");
}

GRADED_TEST(Lab6, InelasticCentralCollision, 3, "L6.3") {
  const Vec3 x = Vec3::UnitX();
  Collision at{movable(1, Vec3(1, 1, 1)), movable(3, Vec3(1, 1, 1)), touching(x, x, -x, 0)};
  at.a.v = Vec3(5, 0, 0);
  at.constraint.normal_impulse = Real(0.5);
  const Collision before = at;

  Story story = with_causes(Story("Bodies that do not bounce go on together"));
  story.given("1 kg at 5 m/s into 3 kg at rest").given("e", 0).when("one pass");
  story.picture([&] { return collision_picture(before, at); });
  collide(at);
  // v = (1 · 5 + 3 · 0)/(1 + 3).
  story.expect_near("v_A", at.a.v, Vec3(Real(1.25), 0, 0), 1e-6, "m/s");
  story.expect_near("v_B", at.b.v, Vec3(Real(1.25), 0, 0), 1e-6, "m/s");
  story.expect_near("ω_A", at.a.w, Vec3::Zero(), 0, "rad/s");
  story.expect_near("ω_B", at.b.w, Vec3::Zero(), 0, "rad/s");
  Story gathered("A constraint adds up its impulses");
  gathered.given("1 kg at 5 m/s into 3 kg at rest").given("e", 0);
  gathered.given("normal_impulse before", before.constraint.normal_impulse, "N·s");
  gathered.when("one pass");
  gathered.likely(gathers_impulses);
  gathered.expect_near("impulse of the constraint, 0.5 N·s before", at.constraint.normal_impulse,
                       4.25, 1e-6, "N·s");
}

GRADED_TEST(Lab6, ObliqueImpactOnTheTipOfARod, 4, "L6.3") {
  // A rod of mass M and length l along x, hit across its tip by a point mass m: 1/m_e = 1/m + 4/M,
  // and the rod takes V = j/M, ω = 6·j/(M·l). The motion along the rod is not affected.
  const Vec3 z = Vec3::UnitZ();
  Collision at;
  at.a.inverse_mass = 1;
  at.a.v = Vec3(3, 0, 4);
  at.b.inverse_mass = Real(0.5);
  at.b.world_inverse_inertia.diagonal() = Vec3(0, Real(1) / Real(1.5), Real(1) / Real(1.5));
  at.constraint = touching(z, Vec3::Zero(), Vec3(Real(-1.5), 0, 0), 0);
  const Collision point_and_rod = at;

  Story story =
      with_causes(Story("A blow at the tip moves and turns a rod: V = j/M, ω = 6·j/(M·l)"));
  story.given("point mass of 1 kg at (3, 0, 4) m/s").given("rod of 2 kg and 3 m along x, at rest");
  story.given("e", 0).when("one pass");
  story.picture([&] { return collision_picture(point_and_rod, at); });
  collide(at);
  story.expect_near("impulse", at.constraint.normal_impulse, 4.0 / 3, 1e-6, "N·s");
  story.expect_near("v of the point mass", at.a.v, Vec3(3, 0, Real(8) / 3), 1e-6, "m/s");
  story.expect_near("V of the rod", at.b.v, Vec3(0, 0, Real(2) / 3), 1e-6, "m/s");
  story.expect_near("ω of the rod", at.b.w, Vec3(0, Real(4) / 3, 0), 1e-6, "rad/s");

  Random random(64);
  for (const Real size : {Real(1), Real(0.01), Real(100)}) {
    Collision boxes = random_collision(random, size);
    const Collision before = boxes;
    const ContactConstraint& constraint = before.constraint;
    const Vector12 jacobian = dense_jacobian(constraint.n, constraint.r_a, constraint.r_b);
    const Vector12 velocity = dense_velocity(before.a, before.b);
    const double mass =
        dense_effective_mass(before.a, before.b, constraint.r_a, constraint.r_b, constraint.n);
    const Vector12 change =
        dense_inverse_mass(before.a, before.b) * jacobian * (-jacobian.dot(velocity) * mass);
    const Vector12 exact = velocity + change;
    Story here = with_causes(Story("After the impulse, V' = V + M⁻¹·Jᵀ·j"));
    here.seed(random.seed())
        .given("two random boxes of size " + Story::show(size, "m"))
        .given("e", 0);
    here.picture([&] { return collision_picture(before, boxes); });
    collide(boxes);
    const auto expected = [&exact](int first) {
      return Vec3(exact.segment<3>(first).cast<Real>());
    };
    // A few roundings of float at speeds of some sizes per second.
    here.expect_near("v_A", boxes.a.v, expected(0), 1e-4 * size, "m/s");
    here.expect_near("ω_A", boxes.a.w, expected(3), 1e-4, "rad/s");
    here.expect_near("v_B", boxes.b.v, expected(6), 1e-4 * size, "m/s");
    here.expect_near("ω_B", boxes.b.w, expected(9), 1e-4, "rad/s");
  }
}

std::string motion_text(const SolverBody& body) {
  return Story::show(body.v, "m/s") + ", " + Story::show(body.w, "rad/s");
}

/// Checks that the bodies approach each other.
void require_blow(Collision at) {
  const Collision before = at;
  Story story = with_causes(Story("Bodies that approach get an impulse"));
  story.given("two overlapping boxes with v_n < 0").when("one pass");
  story.picture([&] { return collision_picture(before, at); });
  collide(at);
  require(story.expect("v_A changes", !same_motion(at.a, before.a), Story::show(at.a.v, "m/s"),
                       "other than " + Story::show(before.a.v, "m/s")));
  require(story.expect("v_B changes", !same_motion(at.b, before.b), Story::show(at.b.v, "m/s"),
                       "other than " + Story::show(before.b.v, "m/s")));
}

GRADED_TEST(Lab6, BodiesThatSeparateAreLeftAlone, 2, "L6.3") {
  Random random(65);
  for (int i = 0; i < 20; ++i) {
    Collision at = random_collision(random, 1);
    require_blow(at);
    at.constraint.n = -at.constraint.n;
    at.constraint.normal_impulse = Real(0.25);
    const Collision before = at;
    Story story("Bodies that already part are not pulled back");
    story.seed(random.seed()).given("two overlapping boxes with v_n > 0").when("one pass");
    story.picture([&] { return collision_picture(before, at); });
    Story gathered = story;
    gathered.likely(gathers_impulses);
    story.likely("only approaching bodies collide: v_n < 0")
        .likely("a contact can push, never pull: j must not become negative");
    collide(at);
    require(story.expect("v_A and ω_A", same_motion(at.a, before.a), motion_text(at.a),
                         "as before: " + motion_text(before.a)));
    require(story.expect("v_B and ω_B", same_motion(at.b, before.b), motion_text(at.b),
                         "as before: " + motion_text(before.b)));
    require(gathered.expect_near("impulse of the constraint, 0.25 N·s before",
                                 at.constraint.normal_impulse, 0.25, 0, "N·s"));
  }
}

GRADED_TEST(Lab6, GapsAreLeftAlone, 2, "L6.3") {
  Random random(66);
  struct Case {
    Real separation;
    bool touches;
  };
  for (const Case& at :
       {Case{Real(0.1), false}, Case{Real(1e-4), false}, Case{0, true}, Case{Real(-0.05), true}}) {
    Collision collision = random_collision(random, 1);
    collision.constraint.separation = at.separation;
    const Collision before = collision;
    Story story("Bodies collide once they touch (separation ≤ 0), not before");
    story.seed(random.seed()).given("separation", at.separation, "m").given("approaching boxes");
    story.when("one pass");
    story.likely("a constraint with a gap is there for the solver of lab 7: skip separation > 0")
        .likely("touching counts: separation = 0 is a contact");
    collide(collision);
    const bool struck = !same_motion(collision.a, before.a) && !same_motion(collision.b, before.b);
    story.expect_equal("an impulse was given", struck, at.touches);
    story.expect_equal("the constraint has gathered an impulse",
                       collision.constraint.normal_impulse > 0, at.touches);
  }
}

GRADED_TEST(Lab6, ImmovableBodiesStay, 3, "L6.3") {
  const Vec3 z = Vec3::UnitZ();
  Story story = with_causes(Story("An immovable body gives impulses and takes none"));

  Collision floor{SolverBody{}, movable(2, Vec3(1, 1, 1)), touching(z, Vec3(4, 0, 0), -z, 0)};
  floor.b.v = Vec3(1, 0, -3);
  Story landing = story;
  landing.given("a floor").given("a 2 kg cube that lands on it at (1, 0, −3) m/s").given("e", 0);
  collide(floor);
  landing.expect_near("v of the cube", floor.b.v, Vec3(1, 0, 0), 1e-6, "m/s");
  landing.expect_near("v of the floor", floor.a.v, Vec3::Zero(), 0, "m/s");
  landing.expect_near("ω of the floor", floor.a.w, Vec3::Zero(), 0, "rad/s");

  Collision lift{movable(2, Vec3(1, 1, 1)), SolverBody{}, touching(-z, -z, z, 0)};
  lift.b.v = Vec3(0, 0, 2);
  Story lifted = story;
  lifted.given("a kinematic lift that rises at 2 m/s, as B").given("a cube that rests, as A");
  collide(lift);
  lifted.expect_near("v of the cube", lift.a.v, Vec3(0, 0, 2), 1e-6, "m/s");
  lifted.expect_near("v of the lift", lift.b.v, Vec3(0, 0, 2), 0, "m/s");

  Collision walls{SolverBody{}, SolverBody{}, touching(z, z, -z, 1)};
  walls.b.v = Vec3(0, 0, -1);
  Story both = story;
  both.given("two immovable bodies that approach");
  collide(walls);
  both.expect_near("v of the moving one", walls.b.v, Vec3(0, 0, -1), 0, "m/s");
  both.expect_near("v of the other", walls.a.v, Vec3::Zero(), 0, "m/s");
  both.expect_near("impulse", walls.constraint.normal_impulse, 0, 0, "N·s");
}

}  // namespace
}  // namespace cs550::test
