/// @file prepare_contacts.cpp
/// L7.2 and L7.4 for the engine: the masses of eight constraints at a time, with the bits of the teaching
/// form.

#include "kernels.hpp"

namespace cs550 {

void prepare_contacts(std::span<ContactConstraint> constraints, std::span<const SolverBody> bodies,
                      const ContactStep& step) {
#if CS550_HAS_AVX2_FORMS
  if (has_avx2()) return lanes_of_eight::prepare_contacts(constraints, bodies, step);
#endif
  lanes_of_four::prepare_contacts(constraints, bodies, step);
}

}  // namespace cs550
