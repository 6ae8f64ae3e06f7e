// Piles of other sizes, materials and directions for lab 7.
#include <cs550/graded_test.hpp>

#include "lab7_constraint_solver/piles.hpp"

namespace cs550::test {
namespace {

GRADED_TEST(Lab7, PilesOfEverySizeStandStill, 1, "L7.8", Long) {
  for (const Variation& variation :
       {Variation{1, 0, 1000, 1, percent}, Variation{2, 17, 50, Real(0.1), 0},
        Variation{4, 0, 1000, percent, 0}, Variation{5, 17, 8000, 100, percent},
        Variation{6, 45, 50, 1, 0}, Variation{7, 0, 50, Real(0.1), percent},
        Variation{8, 45, 1000, 10, 0}}) {
    require_tower(variation);
  }
  require_pyramid(20, {10, 17, 50, percent, percent});
}

}  // namespace
}  // namespace cs550::test
