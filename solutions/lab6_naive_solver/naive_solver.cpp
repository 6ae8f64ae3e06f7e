#include "cs550/naive_solver.hpp"

namespace cs550 {
namespace {

/// How much a unit impulse along d at r changes the velocity of that point along d, through the
/// turn of the body alone: d·[(I⁻¹(r × d)) × r]. The bracket matters: the cross product comes last.
Real turning_response(const BodyVelocity& body, const Vec3& r, const Vec3& d) {
  const Vec3 turn = body.world_inverse_inertia * r.cross(d);
  return d.dot(turn.cross(r));
}

/// j = −(1 + e)·v_n·m_e for a contact that touches and approaches, else none.
Real collision_impulse(const ContactRow& row, const BodyVelocity& a, const BodyVelocity& b) {
  const Real v_n = normal_velocity(a, b, row.r_a, row.r_b, row.n);
  if (row.separation > 0 || v_n >= 0) return 0;
  return -(1 + row.restitution) * v_n * effective_mass(a, b, row.r_a, row.r_b, row.n);
}

}  // namespace

// L6.1
Real effective_mass(const BodyVelocity& a, const BodyVelocity& b, const Vec3& r_a, const Vec3& r_b,
                    const Vec3& direction) {
  const Real inverse = a.inverse_mass + b.inverse_mass + turning_response(a, r_a, direction) +
                       turning_response(b, r_b, direction);
  return inverse > 0 ? 1 / inverse : 0;
}

// L6.2
Real normal_velocity(const BodyVelocity& a, const BodyVelocity& b, const Vec3& r_a, const Vec3& r_b,
                     const Vec3& n) {
  return n.dot(b.v + b.w.cross(r_b) - a.v - a.w.cross(r_a));
}

// L6.3, L6.4
void resolve_contacts_naive(std::span<ContactRow> rows, std::span<BodyVelocity> bodies) {
  for (ContactRow& row : rows) {
    BodyVelocity& a = bodies[static_cast<std::size_t>(row.body_a)];
    BodyVelocity& b = bodies[static_cast<std::size_t>(row.body_b)];
    const Real j = collision_impulse(row, a, b);
    a.apply(-j * row.n, row.r_a);
    b.apply(j * row.n, row.r_b);
    row.normal_impulse += j;
  }
}

}  // namespace cs550
