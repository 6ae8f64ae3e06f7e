#include "cs550/naive_solver.hpp"

namespace cs550 {
namespace {

/// How much a unit impulse along d at r changes the velocity of that point along d, through the
/// turn of the body alone: d·[(W(r × d)) × r]. The bracket matters: the cross product comes last.
Real turning_response(const SolverBody& body, const Vec3& r, const Vec3& d) {
  const Vec3 turn = body.world_inverse_inertia * r.cross(d);
  return d.dot(turn.cross(r));
}

/// j = −(1 + e)·v_n·m_e for a contact that touches and approaches, else none.
Real collision_impulse(const ContactConstraint& constraint, const SolverBody& a,
                       const SolverBody& b) {
  const Real v_n = normal_velocity(a, b, constraint.r_a, constraint.r_b, constraint.n);
  if (constraint.separation > 0 || v_n >= 0) return 0;
  return -(1 + constraint.restitution) * v_n *
         effective_mass(a, b, constraint.r_a, constraint.r_b, constraint.n);
}

}  // namespace

// L6.1
Real effective_mass(const SolverBody& a, const SolverBody& b, const Vec3& r_a, const Vec3& r_b,
                    const Vec3& direction) {
  const Real inverse = a.inverse_mass + b.inverse_mass + turning_response(a, r_a, direction) +
                       turning_response(b, r_b, direction);
  return inverse > 0 ? 1 / inverse : 0;
}

// L6.2
Real normal_velocity(const SolverBody& a, const SolverBody& b, const Vec3& r_a, const Vec3& r_b,
                     const Vec3& n) {
  return n.dot(b.v + b.w.cross(r_b) - a.v - a.w.cross(r_a));
}

// L6.3, L6.4
void resolve_contacts_naive(std::span<ContactConstraint> constraints,
                            std::span<SolverBody> bodies) {
  for (ContactConstraint& constraint : constraints) {
    SolverBody& a = bodies[constraint.body_a];
    SolverBody& b = bodies[constraint.body_b];
    const Real j = collision_impulse(constraint, a, b);
    a.apply(-j * constraint.n, constraint.r_a);
    b.apply(j * constraint.n, constraint.r_b);
    constraint.normal_impulse += j;
  }
}

}  // namespace cs550
