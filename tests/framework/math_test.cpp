// Functions of math.hpp that must have the same bits with every C library.

#include "cs550/math.hpp"

#include <gtest/gtest.h>

namespace cs550 {
namespace {

TEST(SineAndCosine, AreTheNearestNumbers) {
  // A long double has 40 bits more than a float: rounding twice cannot matter for these angles.
  for (int i = -20'000; i <= 20'000; ++i) {
    const Real angle = static_cast<Real>(i) * Real(3.7e-4);  // up to 7.4 rad
    EXPECT_EQ(sine(angle), static_cast<Real>(std::sin(static_cast<long double>(angle))));
    EXPECT_EQ(cosine(angle), static_cast<Real>(std::cos(static_cast<long double>(angle))));
  }
}

}  // namespace
}  // namespace cs550
