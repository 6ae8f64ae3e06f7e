// The times at which an animation shows its pictures.
#include "viewer/animation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace cs550::test {
namespace {

using viewer::Still;
using viewer::stills;

TEST(Animation, AWalkHasAllPictures) {
  EXPECT_EQ(stills(3, 2.5), (std::vector<Still>{{0, 40}, {1, 40}, {2, 40}}));
}

TEST(Animation, ARunTakesTheTimeOfItsSteps) {
  for (const double h : {1.0 / 60, 0.002, static_cast<double>(0.01F), 0.04}) {
    const int count = static_cast<int>(std::lround(6 / h));
    const std::vector<Still> all = stills(count, 1 / h);
    int hundredths = 0;
    for (const Still& still : all) {
      EXPECT_GE(still.delay, 3) << h;
      hundredths += still.delay;
    }
    EXPECT_NEAR(hundredths, 600, 4) << h;
    EXPECT_GE(all.size(), 125U) << h;
  }
}

TEST(Animation, StepsOfAMicrosecondAreOnePicture) {
  EXPECT_EQ(stills(120, 1e6), (std::vector<Still>{{0, 3}}));
}

}  // namespace
}  // namespace cs550::test
