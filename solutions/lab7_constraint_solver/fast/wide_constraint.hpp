#pragma once
/// @file wide_constraint.hpp
/// The constraints of a row, one in each lane, as the mirror keeps them.

#include <bit>
#include <cstddef>
#include <span>

#include "cs550/contact_constraint.hpp"
#include "engine/constraint_mirror.hpp"
#include "engine/wide_structs.hpp"

namespace cs550::CS550_LANES {

/// Unused lanes hold a constraint without mass.
struct WideConstraint {
  WideVec3 n, u, r_a, r_b;
  WideReal separation, friction, normal_mass;
  WideMat2 tangent_mass;
  WideReal bias_rate, mass_scale, impulse_scale;
  WideReal flags;  ///< impact_handled, and whether the last warm start loaded it
  WideReal normal_impulse, tangent_u, tangent_v;
  WideReal restitution, approach_velocity;  ///< a cache line that soft contacts do not need
};

/// The flag impact_handled is the first byte of its number, and true is 1. The other flag is in the same number:
/// one more would spread a row over one more cache line.
/// @{
static_assert(std::endian::native == std::endian::little);
inline constexpr int handled_bit = 1;
inline constexpr int loaded_bit = 2;
/// @}

inline PartMask bits_of(const WideReal& flags, std::size_t part) {
  return __builtin_bit_cast(PartMask, flags.part[part]);
}
inline WideReal only(const WideReal& flags, int bit) {
  return by_part([&](std::size_t i) { return __builtin_bit_cast(Part, bits_of(flags, i) & bit); });
}
/// Adds a bit to the lanes of the mask.
inline WideReal with(const WideReal& flags, int bit, const WideMask& where) {
  return by_part([&](std::size_t i) {
    return __builtin_bit_cast(Part, bits_of(flags, i) | (where.part[i] & bit));
  });
}
inline WideMask has(const WideReal& flags, int bit) {
  return mask_by_part([&](std::size_t i) { return (bits_of(flags, i) & bit) != 0; });
}

inline constexpr std::size_t lines_per_row = sizeof(WideConstraint) / sizeof(LaneNumbers);

/// The rows of a mirror.
inline std::span<WideConstraint> wide_constraints(ConstraintMirror& mirror) {
  static_assert(sizeof(WideConstraint) == lines_per_row * sizeof(LaneNumbers));
  static_assert(alignof(WideConstraint) <= alignof(LaneNumbers));
  return {reinterpret_cast<WideConstraint*>(mirror.numbers.data()), mirror.rows.size()};
}

/// The constraints of a row, and an idle one in the other lanes.
template <class Constraint>
PerLane<Constraint> lanes_of(std::span<Constraint> constraints, const ConstraintRow& row,
                             Constraint& idle) {
  PerLane<Constraint> lanes;
  for (Index lane = 0; lane < static_cast<Index>(lane_count); ++lane) {
    lanes[lane] = lane < row.count ? &constraints[row.first + lane] : &idle;
  }
  return lanes;
}

/// What passes do not change.
inline void copy_constants(const PerLane<ContactConstraint>& constraints, WideConstraint& copy) {
  using C = ContactConstraint;
  constexpr std::size_t count =
      (offsetof(C, approach_velocity) - offsetof(C, n)) / sizeof(Real) + 1;
  const WideReals<C, count> constraint(constraints, &C::n);
  copy.n = constraint(&C::n);
  copy.u = constraint(&C::u);
  copy.r_a = constraint(&C::r_a);
  copy.r_b = constraint(&C::r_b);
  copy.separation = constraint(&C::separation);
  copy.friction = constraint(&C::friction);
  copy.restitution = constraint(&C::restitution);
  copy.normal_mass = constraint(&C::normal_mass);
  copy.tangent_mass = constraint(&C::tangent_mass);
  copy.bias_rate = constraint(&C::softness, &Softness::bias_rate);
  copy.mass_scale = constraint(&C::softness, &Softness::mass_scale);
  copy.impulse_scale = constraint(&C::softness, &Softness::impulse_scale);
  copy.approach_velocity = constraint(&C::approach_velocity);
}

/// The four Reals of a constraint that hold the flag impact_handled and the three impulses.
inline constexpr std::size_t before_impulses =
    offsetof(ContactConstraint, normal_impulse) - sizeof(Real);
static_assert(offsetof(ContactConstraint, impact_handled) == before_impulses);
static_assert(offsetof(ContactConstraint, tangent_impulse) == before_impulses + 2 * sizeof(Real));

inline void load_impulses(const PerLane<ContactConstraint>& constraints, WideConstraint& copy) {
  const FourReals four = FourReals::load(constraints, [](const ContactConstraint& constraint) {
    return reinterpret_cast<const std::byte*>(&constraint) + before_impulses;
  });
  copy.flags = with(four.first, loaded_bit, has(copy.flags, loaded_bit));
  copy.normal_impulse = four.second;
  copy.tangent_u = four.third;
  copy.tangent_v = four.fourth;
}

inline void mark_loads(WideConstraint& copy) {
  copy.flags = with(only(copy.flags, handled_bit), loaded_bit, copy.normal_impulse > all_lanes(0));
}

/// ContactConstraint::mark_impact().
inline void mark_impacts(WideConstraint& copy) {
  copy.flags = with(copy.flags, handled_bit, copy.normal_impulse > all_lanes(0));
}

inline void store_impulses(const WideConstraint& copy,
                           const PerLane<ContactConstraint>& constraints) {
  FourReals{only(copy.flags, handled_bit), copy.normal_impulse, copy.tangent_u, copy.tangent_v}
      .store(constraints, [](ContactConstraint& constraint) {
        return reinterpret_cast<std::byte*>(&constraint) + before_impulses;
      });
}

}  // namespace cs550::CS550_LANES
