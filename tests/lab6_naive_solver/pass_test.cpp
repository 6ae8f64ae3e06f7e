// L6.4: restitution, many constraints, and the limits of a single pass.
#include <cs550/graded_test.hpp>

#include "lab6_naive_solver/pictures.hpp"
#include "lab6_naive_solver/stack.hpp"

namespace cs550::test {
namespace {

constexpr const char* one_pass_only =
    "visit the constraints once only: repeated until nothing approaches, the visits may never end";

GRADED_TEST(Lab6, BounceFollowsRestitution, 2, "L6.4") {
  const Vec3 x = Vec3::UnitX();
  struct Case {
    Real e, v_a, v_b;
  };
  // v_B' − v_A' = e · 5 m/s, and v_A' + 3·v_B' = 5 kg·m/s.
  for (const Case& at : {Case{1, Real(-2.5), Real(2.5)}, Case{Real(0.6), Real(-1), 2},
                         Case{0, Real(1.25), Real(1.25)}}) {
    Collision collision{movable(1, Vec3(1, 1, 1)), movable(3, Vec3(1, 1, 1)),
                        touching(x, x, -x, at.e)};
    collision.a.v = Vec3(5, 0, 0);
    Story story("A collision turns the speed of approach into e times that speed, parting");
    story.given("1 kg at 5 m/s into 3 kg at rest").given("e", at.e).when("one pass");
    story.likely("j = −(1 + e)·v_n·m_e: 1 stops the approach, e throws back")
        .likely("j pushes B along n and A against it: −j·n to A, +j·n to B")
        .likely(one_pass_only);
    const Collision before = collision;
    story.picture([&] { return collision_picture(before, collision); });
    collide(collision);
    story.expect_near("v_A", collision.a.v, Vec3(at.v_a, 0, 0), 2e-6, "m/s");
    story.expect_near("v_B", collision.b.v, Vec3(at.v_b, 0, 0), 2e-6, "m/s");
  }
}

GRADED_TEST(Lab6, MomentumIsKeptAndEnergyNeverGrows, 4, "L6.4") {
  Random random(67);
  for (const Real size : {Real(1), Real(0.01), Real(100)}) {
    for (const Real e : {Real(0), Real(0.5), Real(1)}) {
      for (int i = 0; i < 10; ++i) {
        Collision at = random_collision(random, size, e);
        const Collision before = at;
        Story story("A collision keeps P and L, and gives no energy for e ≤ 1");
        story.seed(random.seed())
            .given("two random boxes of size " + Story::show(size, "m"))
            .given("e", e);
        story.likely("equal and opposite: what A gets is the opposite of what B gets")
            .likely("each impulse acts at the contact: A's lever is r_A, B's is r_B")
            .likely("the effective mass is too large: the turning terms or the bracket")
            .likely(one_pass_only);
        story.picture([&] { return collision_picture(before, at); });
        collide(at);
        // About the contact point, relative to which the centres of mass are at −r.
        const auto spin = [](const Collision& c) -> Eigen::Vector3d {
          return angular_momentum(c.a, -c.constraint.r_a) +
                 angular_momentum(c.b, -c.constraint.r_b);
        };
        const Eigen::Vector3d momentum = linear_momentum(before.a) + linear_momentum(before.b);
        const Eigen::Vector3d after = linear_momentum(at.a) + linear_momentum(at.b);
        const double energy = kinetic_energy(before.a) + kinetic_energy(before.b);
        const double ratio = (kinetic_energy(at.a) + kinetic_energy(at.b)) / energy;
        const double scale = linear_momentum(before.a).norm() + linear_momentum(before.b).norm();
        // Roundings of float, relative to the momenta that are exchanged.
        require(story.expect("both bodies got an impulse",
                             !same_motion(at.a, before.a) && !same_motion(at.b, before.b)));
        require(
            story.expect_at_most("change of P, relative", (after - momentum).norm() / scale, 1e-5));
        require(story.expect_at_most("change of L about the contact, relative",
                                     (spin(at) - spin(before)).norm() / (scale * size), 2e-5));
        require(story.expect_at_most("energy after / before", ratio, 1 + 1e-5));
        if (e == 1) require(story.expect_near("energy after / before, e = 1", ratio, 1, 1e-5));
      }
    }
  }
}

/// Checks a pass over three cubes in a line whose first contact gets no impulse.
void require_visits_of_later_contacts() {
  const Vec3 right = Vec3(Real(0.5), 0, 0);
  Story story("One pass visits every constraint, whatever the ones before it needed");
  story.likely("a contact without impulse is skipped; the ones after it are still visited")
      .likely("change the bodies of the span, not copies of them");
  for (const Real gap : {Real(0), Real(0.1)}) {
    std::vector<SolverBody> bodies(3, movable(1, Vec3::Constant(Real(0.5))));
    bodies[0].v = Vec3(3, 0, 0);
    std::vector<ContactConstraint> constraints = {touching(Vec3::UnitX(), right, -right, 0, 1, 2),
                                                  touching(Vec3::UnitX(), right, -right, 0, 0, 1)};
    constraints[0].separation = gap;
    Story here = story;
    here.given("three cubes of 1 kg in a line; the first moves at 3 m/s towards the others")
        .given("the contact of the second and the third, which are at rest, is listed first")
        .given("its gap", gap, "m")
        .when("one pass");
    resolve_contacts_naive(constraints, bodies);
    require(here.expect_near("speeds of the three",
                             Vec3(bodies[0].v.x(), bodies[1].v.x(), bodies[2].v.x()),
                             Vec3(Real(1.5), Real(1.5), 0), 1e-6, "m/s"));
  }
}

GRADED_TEST(Lab6, OnePassCannotHoldAStack, 4, "L6.4") {
  Story story("One pass over the constraints takes half a box's approach off it and hands it down");
  story.likely("constraints are visited once, in order, and each sees what the ones before it did")
      .likely(one_pass_only)
      .likely("change the bodies of the span, not copies of them")
      .likely("only approaching bodies collide: v_n < 0");
  // From below: u₁ = 0 at the floor, then each contact levels a box with the one above it, which
  // still falls at g·h: v_k = (v_k − g·h)/2 leaves −(1 − 2⁻ᵏ)·g·h, the top as the one below it.
  const Real speed = Real(9.81) / 60;
  constexpr int boxes = 10;
  Stack stack(boxes);
  stack.fall(speed);
  Story once = story;
  once.given("a tower of " + std::to_string(boxes) + " boxes of 1 kg")
      .given("g·h", speed, "m/s")
      .when("one pass, from below");
  resolve_contacts_naive(stack.constraints, stack.bodies);
  for (int k = 1; k <= boxes; ++k) {
    const double left = 1 - std::exp2(-std::min(k, boxes - 1));
    const double got = stack.bodies[k].v.z();
    once.expect_near("v of box " + std::to_string(k), got, -left * speed, 1e-6, "m/s");
  }

  for (const int height : {1, boxes}) {
    Stack tower(height);
    Story second = story;
    second.given("boxes", height).when("1 s at 60 Hz, one pass a step");
    for (int i = 0; i < 60; ++i) {
      tower.fall(speed);
      resolve_contacts_naive(tower.constraints, tower.bodies);
      tower.move(Real(1) / 60);
    }
    const Real sunk = static_cast<Real>(height) - Real(0.5) - tower.heights.back();
    if (height == 1) {
      second.expect_near("top sunk by", sunk, 0, 1e-6, "m");
    } else {
      // Free fall would be 4.9 m; lab 7 holds the same stack within a centimetre.
      second.expect_at_least("top sunk by", sunk, 1, "m");
    }
  }
  require_visits_of_later_contacts();
}

}  // namespace
}  // namespace cs550::test
