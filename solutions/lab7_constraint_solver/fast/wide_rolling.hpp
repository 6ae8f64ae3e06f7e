#pragma once
/// @file wide_rolling.hpp
/// The rolling resistance of eight contacts at a time, each lane with the bits of the teaching form.
/// Two source files include it, one for each width of register.

#include "engine/contacts/rolling_resistance.hpp"
#include "engine/wide_structs.hpp"
#include "kernels.hpp"
#include "passes.hpp"

namespace cs550::CS550_LANES {

/// The rotation of eight solver bodies.
struct WideRotation {
  WideVec3 w;
  WideReal inverse_mass;
  WideMat3 inverse_inertia;

  explicit WideRotation(const PerLane<SolverBody>& bodies)
      : WideRotation(Reals(bodies, &SolverBody::w)) {}

  /// A block of four Reals: w, and one that stays as it is.
  void store(const PerLane<SolverBody>& bodies) const {
    FourReals{w.x, w.y, w.z, inverse_mass}.store(bodies,
                                                 [](SolverBody& body) { return body.w.data(); });
  }

 private:
  using Reals = WideReals<SolverBody, 13>;

  explicit WideRotation(const Reals& body)
      : w(body(&SolverBody::w)),
        inverse_mass(body(&SolverBody::inverse_mass)),
        inverse_inertia(body(&SolverBody::world_inverse_inertia)) {}
};

inline WideVec3 select(WideMask mask, const WideVec3& a, const WideVec3& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}

inline void slow_rotation(WideRotation& a, WideRotation& b, WideReal limit) {
  const WideReal zero = all_lanes(0);
  const WideVec3 relative = b.w - a.w;
  const WideReal speed = square_root(relative.dot(relative));
  const WideVec3 axis{relative.x / speed, relative.y / speed, relative.z / speed};
  const WideVec3 response_a = a.inverse_inertia * axis;
  const WideVec3 response_b = b.inverse_inertia * axis;
  const WideReal response = axis.dot(response_a + response_b);
  const WideReal impulse = smaller(limit, speed / response);
  const WideMask turns = ~(speed == zero) & (response > zero);
  a.w = select(turns, a.w + impulse * response_a, a.w);
  b.w = select(turns, b.w - impulse * response_b, b.w);
}

/// resist_rolling(). The loads are those of the mirror: eight impulses of a row are neighbours there.
[[gnu::flatten]] void resist_rolling(ConstraintMirror& mirror, const SolveOrder& /*order*/,
                                     std::span<const ContactConstraint> /*constraints*/,
                                     std::span<SolverBody> bodies, Real lever) {
  for (const PairGroup& group : mirror.groups) {
    WideReal load = all_lanes(0);
    for (const WideConstraint& row : rows_of(group, mirror)) load = load + row.normal_impulse;
    GroupBodies pair(group, bodies);
    WideRotation a(pair.a());
    WideRotation b(pair.b());
    slow_rotation(a, b, all_lanes(lever) * load);
    pair.spare_immovable();
    a.store(pair.a());
    b.store(pair.b());
  }
}

}  // namespace cs550::CS550_LANES
