#pragma once
/// @file masses.hpp
/// L7.1, L7.2 and L7.4 for eight constraints at a time, each lane with the bits of the teaching form.
/// Two source files include it, one for each width of register.

#include "cs550/constraint_solver.hpp"
#include "kernels.hpp"
#include "wide_body.hpp"

namespace cs550::CS550_LANES {

/// What the effective masses of eight constraints depend on.
struct WideLevers {
  WideVec3 n, u, r_a, r_b;

  explicit WideLevers(const PerLane<ContactConstraint>& constraints)
      : WideLevers(WideReals<ContactConstraint, 12>(constraints, &ContactConstraint::n)) {}

 private:
  explicit WideLevers(const WideReals<ContactConstraint, 12>& constraint)
      : n(constraint(&ContactConstraint::n)),
        u(constraint(&ContactConstraint::u)),
        r_a(constraint(&ContactConstraint::r_a)),
        r_b(constraint(&ContactConstraint::r_b)) {}
};

/// The rotational parts of J; the linear ones are −direction and direction.
struct WideJacobian {
  WideVec3 direction, angular_a, angular_b;

  WideJacobian(const WideVec3& along, const WideLevers& levers)
      : direction(along), angular_a(-levers.r_a.cross(along)), angular_b(levers.r_b.cross(along)) {}
};

/// J·M⁻¹·Kᵀ.
inline WideReal coupling(const WideJacobian& j, const WideJacobian& k, const WideBody& a,
                         const WideBody& b) {
  const WideReal linear = j.direction.dot(k.direction);
  return a.inverse_mass * linear + j.angular_a.dot(a.inverse_inertia * k.angular_a) +
         b.inverse_mass * linear + j.angular_b.dot(b.inverse_inertia * k.angular_b);
}

/// The members from normal_mass to softness.
struct WideMasses {
  WideReal normal_mass;
  WideMat2 tangent_mass;
  WideReal bias_rate, mass_scale, impulse_scale;

  WideMasses(const WideLevers& levers, const WideBody& a, const WideBody& b,
             const ContactStep& step) {
    const WideReal zero = all_lanes(0);
    const WideJacobian jn(levers.n, levers);
    const WideReal inverse = coupling(jn, jn, a, b);
    normal_mass = select(inverse > zero, all_lanes(1) / inverse, zero);

    const WideJacobian ju(levers.u, levers);
    const WideJacobian jv(levers.n.cross(levers.u), levers);
    const WideReal uu = coupling(ju, ju, a, b);
    const WideReal uv = coupling(ju, jv, a, b);
    const WideReal vv = coupling(jv, jv, a, b);
    const WideReal determinant = uu * vv - uv * uv;
    const WideMask singular = determinant <= zero;
    const WideReal off_diagonal = select(singular, zero, -uv / determinant);
    tangent_mass = {select(singular, zero, vv / determinant), off_diagonal, off_diagonal,
                    select(singular, zero, uu / determinant)};

    const WideMask with_immovable = (a.inverse_mass == zero) | (b.inverse_mass == zero);
    const auto choose = [&](Real Softness::*member) {
      return select(with_immovable, all_lanes(step.soft_static.*member),
                    all_lanes(step.soft.*member));
    };
    bias_rate = choose(&Softness::bias_rate);
    mass_scale = choose(&Softness::mass_scale);
    impulse_scale = choose(&Softness::impulse_scale);
  }

  /// Two blocks of four Reals.
  void store(const PerLane<ContactConstraint>& constraints) const {
    using C = ContactConstraint;
    static_assert(offsetof(C, softness) - offsetof(C, normal_mass) == 5 * sizeof(Real));
    const auto& [uu, vu, uv, vv] = tangent_mass;
    FourReals{normal_mass, uu, vu, uv}.store(constraints,
                                             [](C& constraint) { return &constraint.normal_mass; });
    FourReals{vv, bias_rate, mass_scale, impulse_scale}.store(
        constraints, [](C& constraint) { return constraint.tangent_mass.data() + 3; });
  }
};

[[gnu::flatten]] void prepare_contacts(std::span<ContactConstraint> constraints,
                                       std::span<const SolverBody> bodies,
                                       const ContactStep& step) {
  ContactConstraint idle;
  const SolverBody at_rest;
  PerLane<ContactConstraint> lanes;
  PerLane<const SolverBody> bodies_a;
  PerLane<const SolverBody> bodies_b;
  for (std::size_t first = 0; first < constraints.size(); first += lane_count) {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const bool used = first + lane < constraints.size();
      lanes[lane] = used ? &constraints[first + lane] : &idle;
      bodies_a[lane] = used ? &bodies[lanes[lane]->body_a] : &at_rest;
      bodies_b[lane] = used ? &bodies[lanes[lane]->body_b] : &at_rest;
    }
    WideMasses(WideLevers(lanes), WideBody(bodies_a), WideBody(bodies_b), step).store(lanes);
  }
}

}  // namespace cs550::CS550_LANES
