#pragma once
/// @file kernels.hpp
/// run_passes(), prepare_contacts() and resist_rolling() in two forms that give the same bits.

#include "engine/contacts/contact_passes.hpp"
#include "engine/contacts/rolling_resistance.hpp"
#include "engine/instruction_set.hpp"

namespace cs550 {

namespace lanes_of_four {
void run_passes(ConstraintMirror& mirror, std::span<ContactConstraint> constraints,
                std::span<SolverBody> bodies, const ContactStep& step, const Passes& passes);
void prepare_contacts(std::span<ContactConstraint> constraints, std::span<const SolverBody> bodies,
                      const ContactStep& step);
void resist_rolling(ConstraintMirror& mirror, const SolveOrder& order,
                    std::span<const ContactConstraint> constraints, std::span<SolverBody> bodies,
                    Real lever);
}  // namespace lanes_of_four

#if CS550_HAS_AVX2_FORMS
/// @pre has_avx2()
namespace lanes_of_eight {
void run_passes(ConstraintMirror& mirror, std::span<ContactConstraint> constraints,
                std::span<SolverBody> bodies, const ContactStep& step, const Passes& passes);
void prepare_contacts(std::span<ContactConstraint> constraints, std::span<const SolverBody> bodies,
                      const ContactStep& step);
void resist_rolling(ConstraintMirror& mirror, const SolveOrder& order,
                    std::span<const ContactConstraint> constraints, std::span<SolverBody> bodies,
                    Real lever);
}  // namespace lanes_of_eight
#endif

}  // namespace cs550
