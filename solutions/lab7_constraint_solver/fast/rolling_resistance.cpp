/// @file rolling_resistance.cpp
/// Rolling resistance for the engine: eight contacts at a time, with the bits of given code's form.

#include "kernels.hpp"

namespace cs550 {

void resist_rolling(ConstraintMirror& mirror, const SolveOrder& order,
                    std::span<const ContactConstraint> constraints, std::span<SolverBody> bodies,
                    Real lever) {
#if CS550_HAS_AVX2_FORMS
  if (has_avx2()) return lanes_of_eight::resist_rolling(mirror, order, constraints, bodies, lever);
#endif
  lanes_of_four::resist_rolling(mirror, order, constraints, bodies, lever);
}

}  // namespace cs550
