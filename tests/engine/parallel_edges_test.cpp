// What parallel_sine costs: the separation of boxes whose closest edges are nearly parallel, against
// brute force in double precision. The bounds are derived in the book's chapter on accuracy.

#include <gtest/gtest.h>

#include "cs550/separating_axis.hpp"
#include "engine/test_bodies.hpp"
#include "helpers/exact_separation.hpp"

namespace cs550 {
namespace {

using namespace test;

struct BoxPair {
  PosedShape a;
  PosedShape b;
};

/// Checks that the separation that is reported is
/// - no larger than the true one,
/// - for overlapping boxes at most 2·parallel_sine·radius smaller,
/// - for boxes apart at least cos 45° of it, since the normals beside an edge of a box enclose 90°.
void expect_known_loss(const BoxPair& pair) {
  const ExactBody a(pair.a, pair.a.pose.position);
  const ExactBody b(pair.b, pair.a.pose.position);
  const double truth = best_separations(a, b).largest();
  const double reported = double{find_separating_axis(pair.a, pair.b, {}, HUGE_VALF).separation};
  const double radius = double{std::min(pair.a.shape->radius, pair.b.shape->radius)};
  const double rounding = (double{tie_tolerance} + 1e-5) * radius;
  const double loss = 2 * double{parallel_sine} * radius + rounding;
  EXPECT_LE(reported, truth + rounding);
  EXPECT_GE(reported, (truth > 0 ? std::sqrt(0.5) * truth : truth) - loss);
}

TEST(ParallelEdges, BoxesApartAreReportedNearerThanTheyAre) {
  const ShapePtr box = box_shape({Real(0.5), Real(0.3), Real(0.4)});
  // The best pair of edges encloses a sine of 9.85e-4. Along its axis the boxes are 0.1423 m apart,
  // along the best face normal 0.1177 m.
  const BoxPair pair{
      {box.get(),
       {Vec3::Zero(),
        Quat(Real(-0.472099631), Real(0.782539783), Real(0.236982107), Real(-0.329534381))}},
      {box.get(),
       {{Real(0.0121926013), Real(-0.568816662), Real(1.30673289)},
        Quat(Real(-0.581072264), Real(0.438604349), Real(-0.673404566), Real(-0.12848167))}}};
  const ExactBody a(pair.a, pair.a.pose.position);
  const ExactBody b(pair.b, pair.a.pose.position);
  ASSERT_NEAR(best_separations(a, b).largest(), 0.1423, 1e-4) << "the case that was measured";
  expect_known_loss(pair);
}

TEST(ParallelEdges, TheLossIsBounded) {
  Random random(81);
  const ShapePtr box = box_shape(Vec3::Constant(Real(0.5)));
  const Real half_diagonal = std::sqrt(Real(0.5));
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << random.seed() << ", pair " << i);
    // Edges along z face each other along x. They enclose an angle about the limit, or far below it.
    const Real around_a = pi / 4 + random.real(Real(-0.6), Real(0.6));
    const Real around_b = pi / 4 + random.real(Real(-0.6), Real(0.6));
    const Real tilt = random.real(0, 2) * parallel_sine * std::pow(Real(10), -random.real(0, 3));
    const Quat turn = random.orientation();
    const Quat turn_b(Eigen::AngleAxis<Real>(tilt, Vec3::UnitX()));
    const Vec3 offset(2 * half_diagonal + random.real(Real(-0.2), Real(0.3)),
                      random.real(Real(-0.1), Real(0.1)), random.real(Real(-0.1), Real(0.1)));
    const Quat spin_a(Eigen::AngleAxis<Real>(around_a, Vec3::UnitZ()));
    const Quat spin_b(Eigen::AngleAxis<Real>(around_b, Vec3::UnitZ()));
    expect_known_loss({{box.get(), {Vec3::Zero(), (turn * spin_a).normalized()}},
                       {box.get(), {turn * offset, (turn * turn_b * spin_b).normalized()}}});
  }
}

}  // namespace
}  // namespace cs550
