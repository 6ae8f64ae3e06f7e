#pragma once
/// @file kernel_forms.hpp
/// The forms of the solver's kernels, and what their tests share.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

#include "engine/contacts/contact_passes.hpp"
#include "engine/contacts/rolling_resistance.hpp"
#include "engine/instruction_set.hpp"
#include "helpers/random.hpp"

namespace cs550 {

// By the size of the registers. Without solutions they are missing.
namespace lanes_of_four {
[[gnu::weak]] void run_passes(ConstraintMirror& mirror, std::span<ContactConstraint> constraints,
                              std::span<SolverBody> bodies, const ContactStep& step,
                              const Passes& passes);
[[gnu::weak]] void prepare_contacts(std::span<ContactConstraint> constraints,
                                    std::span<const SolverBody> bodies, const ContactStep& step);
[[gnu::weak]] void resist_rolling(ConstraintMirror& mirror, const SolveOrder& order,
                                  std::span<const ContactConstraint> constraints,
                                  std::span<SolverBody> bodies, Real lever);
}  // namespace lanes_of_four
namespace lanes_of_eight {
[[gnu::weak]] void run_passes(ConstraintMirror& mirror, std::span<ContactConstraint> constraints,
                              std::span<SolverBody> bodies, const ContactStep& step,
                              const Passes& passes);
[[gnu::weak]] void prepare_contacts(std::span<ContactConstraint> constraints,
                                    std::span<const SolverBody> bodies, const ContactStep& step);
[[gnu::weak]] void resist_rolling(ConstraintMirror& mirror, const SolveOrder& order,
                                  std::span<const ContactConstraint> constraints,
                                  std::span<SolverBody> bodies, Real lever);
}  // namespace lanes_of_eight

namespace test {

using RunPasses = void(ConstraintMirror&, std::span<ContactConstraint>, std::span<SolverBody>,
                       const ContactStep&, const Passes&);

inline SolverBody random_body(Random& random, bool movable) {
  SolverBody body;
  body.v = random.real(0, 2) * random.unit_vector();
  body.w = random.real(0, 3) * random.unit_vector();
  if (movable) {
    const Mat3 turn = random.orientation().toRotationMatrix();
    const Vec3 inertia(random.real(1, 3), random.real(2, 5), random.real(3, 6));
    body.inverse_mass = random.real(Real(0.1), 2);
    body.world_inverse_inertia = turn * inertia.asDiagonal() * turn.transpose();
    body.delta_position = random.real(0, Real(0.05)) * random.unit_vector();
    body.delta_rotation = random.real(0, Real(0.05)) * random.unit_vector();
  }
  return body;
}

inline bool same_bits(Real x, Real y) {
  return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
}

template <class Vector>
bool same_bits(const Vector& x, const Vector& y) {
  return std::equal(x.begin(), x.end(), y.begin(), [](Real a, Real b) { return same_bits(a, b); });
}

}  // namespace test
}  // namespace cs550
