#pragma once
/// @file replaced.hpp
/// The functions of the reference that have a faster form here. Where objects are linked (link-time
/// optimisation) the reference is compiled with this header, and its definitions are weak. The passes
/// of given code (engine/contacts/contact_passes.hpp) are replaced, too.

#include "cs550/constraint_solver.hpp"

namespace cs550 {

[[gnu::weak]] void prepare_contacts(std::span<ContactConstraint> constraints,
                                    std::span<const SolverBody> bodies, const ContactStep& step);

}  // namespace cs550
