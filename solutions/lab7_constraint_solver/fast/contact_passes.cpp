/// @file contact_passes.cpp
/// L7.5 and L7.8 for the engine: passes over the constraints, eight at a time, with the bits of the
/// teaching form.

#include "kernels.hpp"

namespace cs550 {

void run_passes(ConstraintMirror& mirror, std::span<ContactConstraint> constraints,
                std::span<SolverBody> bodies, const ContactStep& step, const Passes& passes) {
#if CS550_HAS_AVX2_FORMS
  if (has_avx2()) return lanes_of_eight::run_passes(mirror, constraints, bodies, step, passes);
#endif
  lanes_of_four::run_passes(mirror, constraints, bodies, step, passes);
}

bool passes_spare_immovable_bodies() { return true; }

}  // namespace cs550
