#pragma once
// Whether two bodies overlap, by libccd: the algorithm of Gilbert, Johnson & Keerthi (1988). It
// uses only support points and has nothing in common with the separating axis test.

#include "lab4_separating_axis/axis_oracle.hpp"

namespace cs550::test {

bool gjk_overlap(const ExactBody& a, const ExactBody& b);

}  // namespace cs550::test
