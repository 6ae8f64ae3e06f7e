// rotation_exp() against its closed form in double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "cs550/math.hpp"
#include "helpers/random.hpp"

namespace cs550::test {
namespace {

Eigen::Vector4d closed_form(const Vec3& v) {
  const Eigen::Vector3d exact = v.cast<double>();
  const double angle = exact.norm();
  Eigen::Vector4d q;
  q << exact * (angle > 0 ? std::sin(angle / 2) / angle : 0.5), std::cos(angle / 2);
  return q;
}

// Each component is a few products and sums of numbers below 1: three roundings of 6e-8, and the terms
// that the series leave out, 2e-8. Half of an angle above 2 rad is rounded by that much of itself.
constexpr double few_roundings = 2e-7;

TEST(Rotation, ExpAgreesWithItsClosedForm) {
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const Real angle = std::pow(Real(10), random.real(-6, Real(0.79)));  // up to 2π rad
    const Vec3 v = angle * random.unit_vector();
    SCOPED_TRACE(std::to_string(angle) + " rad");
    const Quat q = rotation_exp(v);
    const double bound = few_roundings * std::max(1.0, static_cast<double>(angle) / 2);
    ASSERT_LE((q.coeffs().cast<double>() - closed_form(v)).cwiseAbs().maxCoeff(), bound);
    ASSERT_NEAR(q.norm(), 1, few_roundings);
  }
}

TEST(Rotation, ExpOfZeroIsTheIdentity) {
  EXPECT_EQ(rotation_exp({0, 0, 0}).coeffs(), Quat::Identity().coeffs());
}

TEST(Rotation, ExpHasNoStepWhereItsSeriesEnds) {
  const Real below = std::nextafter(Real(1), Real(0));
  const Real above = std::nextafter(Real(1), Real(2));
  const Quat series = rotation_exp({below, 0, 0});
  const Quat library = rotation_exp({above, 0, 0});
  EXPECT_LE((series.coeffs() - library.coeffs()).cwiseAbs().maxCoeff(), few_roundings);
}

}  // namespace
}  // namespace cs550::test
