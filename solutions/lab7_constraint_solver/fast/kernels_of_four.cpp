#include "kernels.hpp"
#include "masses.hpp"
#include "passes.hpp"

namespace cs550::lanes_of_four {

void run_passes(ConstraintMirror& mirror, std::span<ContactConstraint> constraints,
                std::span<SolverBody> bodies, const ContactStep& step, const Passes& passes) {
  run_wide_passes(mirror, constraints, bodies, step, passes);
}

void prepare_contacts(std::span<ContactConstraint> constraints, std::span<const SolverBody> bodies,
                      const ContactStep& step) {
  prepare_all(constraints, bodies, step);
}

}  // namespace cs550::lanes_of_four
