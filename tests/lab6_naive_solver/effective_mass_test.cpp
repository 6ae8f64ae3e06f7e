// L6.1 and L6.2: effective mass and normal velocity.
#include <cs550/graded_test.hpp>

#include "lab6_naive_solver/pictures.hpp"

namespace cs550::test {
namespace {

Story with_mass_causes(Story story) {
  return story.likely("the bracket: d·[(W(r × d)) × r], the cross product with r comes last")
      .likely("the turning terms are missing, or their sign is wrong: both make the mass smaller")
      .likely("a mass is impulse per velocity: the sum is its inverse");
}

Story with_velocity_causes(Story story) {
  return story.likely("v_n is B's velocity less A's, along n, which points from A to B")
      .likely("a point at r of a turning body moves by ω × r as well, in that order");
}

GRADED_TEST(Lab6, EffectiveMassMatchesDense, 6, "L6.1") {
  Random random(61);
  Story story = with_mass_causes(Story("m_e = 1/(J·M⁻¹·Jᵀ), with M⁻¹ written out as 12 × 12"));
  story.seed(random.seed()).when("effective_mass() of two random boxes");
  for (const Real size : {Real(1), Real(0.01), Real(100)}) {
    for (int i = 0; i < 20; ++i) {
      const Collision at = random_collision(random, size);
      const Vec3 d = random.unit_vector();
      const double exact =
          dense_effective_mass(at.a, at.b, at.constraint.r_a, at.constraint.r_b, d);
      Story here = story;
      here.given("size", size, "m")
          .given("r_A", at.constraint.r_a, "m")
          .given("r_B", at.constraint.r_b, "m");
      const double got = effective_mass(at.a, at.b, at.constraint.r_a, at.constraint.r_b, d);
      // All terms are positive, so there is no cancellation, only a few roundings of float.
      require(here.expect_near("m_e", got, exact, 1e-5 * exact, "kg"));
    }
  }
}

GRADED_TEST(Lab6, EffectiveMassOfKnownCases, 4, "L6.1") {
  const Vec3 x = Vec3::UnitX();
  const Vec3 z = Vec3::UnitZ();
  const SolverBody fixed;
  const SolverBody one = movable(1, Vec3(1, 1, 1));
  const SolverBody three = movable(3, Vec3(1, 1, 1));

  Story central =
      with_mass_causes(Story("A central blow meets the reduced mass m_A·m_B/(m_A + m_B)"));
  central.given("masses", "1 kg and 3 kg");
  central.expect_near("m_e", effective_mass(one, three, x, -x, x), 0.75, 1e-6, "kg");

  Story wall =
      with_mass_causes(Story("A central blow against an immovable body meets the whole mass"));
  wall.given("mass", 3.0f, "kg");
  wall.expect_near("m_e", effective_mass(fixed, three, x, -x, x), 3, 1e-6, "kg");

  // A thin rod of length l: I = m·l²/12, so 1/m_e = 1/m + (l/2)²/I = 4/m.
  SolverBody rod;
  rod.inverse_mass = Real(0.5);
  rod.world_inverse_inertia.diagonal() = Vec3(0, Real(1) / 6, Real(1) / 6);
  Story tip = with_mass_causes(Story("At its tip, a thin rod is only a quarter as hard to move"));
  tip.given("a rod of 2 kg and 6 m, hit across it at its tip");
  tip.expect_near("m_e", effective_mass(fixed, rod, x, 3 * x, z), 0.5, 1e-6, "kg");
}

GRADED_TEST(Lab6, EffectiveMassOfImmovableAndSwappedBodies, 4, "L6.1") {
  const SolverBody fixed;
  Story story("Two immovable bodies have the effective mass 0, by agreement");
  story.likely("1/0 is infinite, and infinity times zero is not a number in the next line");
  story.expect_near(
      "m_e", effective_mass(fixed, fixed, Vec3(1, 2, 3), Vec3(3, 2, 1), Vec3::UnitY()), 0, 0, "kg");

  Random random(62);
  for (int i = 0; i < 20; ++i) {
    const Collision at = random_collision(random, 1);
    const Vec3 d = at.constraint.n;
    Story here = with_mass_causes(Story("m_e asks neither who is A nor which way the blow goes"));
    here.seed(random.seed())
        .given("r_A", at.constraint.r_a, "m")
        .given("r_B", at.constraint.r_b, "m");
    const double mass = effective_mass(at.a, at.b, at.constraint.r_a, at.constraint.r_b, d);
    const double swapped = effective_mass(at.b, at.a, at.constraint.r_b, at.constraint.r_a, d);
    const double reversed = effective_mass(at.a, at.b, at.constraint.r_a, at.constraint.r_b, -d);
    const double reduced = 1 / double{at.a.inverse_mass + at.b.inverse_mass};
    const double exact = dense_effective_mass(at.a, at.b, at.constraint.r_a, at.constraint.r_b, d);
    require(here.expect_near("m_e", mass, exact, 1e-5 * exact, "kg"));
    require(here.expect_near("m_e with A and B swapped", swapped, exact, 1e-5 * exact, "kg"));
    require(here.expect_near("m_e of the reversed blow", reversed, exact, 1e-5 * exact, "kg"));
    require(here.expect_at_most("m_e of bodies that can turn", mass, reduced * (1 + 1e-5), "kg"));
  }
}

GRADED_TEST(Lab6, NormalVelocityMatchesDense, 4, "L6.2") {
  Random random(63);
  Story story = with_velocity_causes(Story("v_n = J·V, with J and V written out"));
  story.seed(random.seed()).when("normal_velocity() of two random boxes");
  for (const Real size : {Real(1), Real(0.01), Real(100)}) {
    for (int i = 0; i < 20; ++i) {
      Collision at = random_collision(random, size);
      const Vec3 n = random.unit_vector();
      at.constraint.n = n;
      const double exact =
          dense_jacobian(n, at.constraint.r_a, at.constraint.r_b).dot(dense_velocity(at.a, at.b));
      Story here = story;
      here.given("size", size, "m").given("n", n);
      const double got = normal_velocity(at.a, at.b, at.constraint.r_a, at.constraint.r_b, n);
      here.picture([&] { return velocity_picture(at, exact, got); });
      // Speeds of up to ten sizes per second are added and may cancel.
      require(here.expect_near("v_n", got, exact, 1e-5 * size, "m/s"));
    }
  }
}

GRADED_TEST(Lab6, NormalVelocityIsNegativeWhenApproaching, 3, "L6.2") {
  const Vec3 x = Vec3::UnitX();
  SolverBody a = movable(1, Vec3(1, 1, 1));
  SolverBody b = movable(1, Vec3(1, 1, 1));
  Story story =
      with_velocity_causes(Story("v_n is negative when approaching, positive when parting"));
  story.given("n", x).given("A at the left, B at the right");

  a.v = Vec3(5, 1, 0);
  const auto expect_velocity = [&](double expected) {
    const double got = normal_velocity(a, b, x, -x, x);
    Story here = story;
    here.given("v_A", a.v, "m/s").given("v_B", b.v, "m/s");
    here.picture([&] { return velocity_picture({a, b, touching(x, x, -x)}, expected, got); });
    here.expect_near("v_n", got, expected, 0, "m/s");
  };
  expect_velocity(-5);
  b.v = Vec3(7, 0, 2);
  expect_velocity(2);
}

GRADED_TEST(Lab6, NormalVelocityCountsTheTurning, 3, "L6.2") {
  const Vec3 x = Vec3::UnitX();
  const Vec3 y = Vec3::UnitY();
  const SolverBody still = movable(1, Vec3(1, 1, 1));
  SolverBody spinning = still;
  spinning.w = Vec3(0, 0, 4);
  // A point 2 m to the right of an axis along z moves by 4 · 2 m/s along y.
  Story story = with_velocity_causes(Story("A turning body moves its contact points by ω × r"));
  story.given("ω", spinning.w, "rad/s").given("r", Vec3(2 * x), "m").given("n", y);
  const auto expect_velocity = [&](const std::string& what, const Collision& at, double expected) {
    const ContactConstraint& constraint = at.constraint;
    const double got = normal_velocity(at.a, at.b, constraint.r_a, constraint.r_b, constraint.n);
    Story here = story;
    here.picture([&] { return velocity_picture(at, expected, got); });
    here.expect_near(what, got, expected, 0, "m/s");
  };
  expect_velocity("v_n if B turns", {still, spinning, touching(y, -x, 2 * x)}, 8);
  expect_velocity("v_n if A turns", {spinning, still, touching(y, 2 * x, -x)}, -8);
  expect_velocity("v_n along r, where nothing moves", {still, spinning, touching(x, -x, 2 * x)}, 0);
}

}  // namespace
}  // namespace cs550::test
