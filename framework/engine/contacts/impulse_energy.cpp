/// @file impulse_energy.cpp
/// What carried impulses are worth.
///
/// Warm starting assumes that a substep needs the impulses of the last one. An impulse λ at a
/// constraint of effective mass m gives bodies at rest the kinetic energy λ²/2m. If m has become much
/// smaller since, because a needle has turned or because a corner has passed its impulse on to another
/// corner, the same impulse throws the bodies apart. The passes of a substep are too few to take that
/// back, and the next step would carry even more.

#include <algorithm>
#include <cmath>

#include "engine/contacts/contact_constraints.hpp"

namespace cs550 {

namespace {

/// A contact whose impulses are worth up to this many times their former energy keeps them: its
/// masses change a little in every step.
constexpr double allowed_growth = 2;

double impulse_energy(const ContactConstraint& constraint) {
  double energy = 0;
  if (constraint.normal_mass > 0) {
    const double impulse = constraint.normal_impulse;
    energy += impulse * impulse / (2 * static_cast<double>(constraint.normal_mass));
  }
  // ½·λᵀ·M⁻¹·λ of the symmetric 2 × 2 matrix M.
  const double uu = constraint.tangent_mass(0, 0);
  const double uv = constraint.tangent_mass(0, 1);
  const double vv = constraint.tangent_mass(1, 1);
  const double determinant = uu * vv - uv * uv;
  if (determinant > 0) {
    const double u = constraint.tangent_impulse.x();
    const double v = constraint.tangent_impulse.y();
    energy += (vv * u * u - 2 * uv * u * v + uu * v * v) / (2 * determinant);
  }
  return energy;
}

/// That of impulses which push bodies apart at the speed of recovery from penetration.
double push_energy(const WorldState& world, const ContactStep& step,
                   std::span<const Index> places) {
  const double speed = step.max_push_speed;
  double energy = 0;
  for (const Index place : places) {
    energy += static_cast<double>(world.constraints[place].normal_mass) * speed * speed / 2;
  }
  return energy;
}

}  // namespace

double impulse_energy(const WorldState& world, std::span<const Index> places) {
  double energy = 0;
  for (const Index place : places) energy += impulse_energy(world.constraints[place]);
  return energy;
}

void limit_impulse_energy(WorldState& world, const ContactStep& step, std::span<const Index> places,
                          double before) {
  const double now = impulse_energy(world, places);
  if (now <= allowed_growth * before || now <= push_energy(world, step, places)) return;
  const auto scale = static_cast<Real>(std::sqrt(before / now));
  for (const Index place : places) {
    world.constraints[place].normal_impulse *= scale;
    world.constraints[place].tangent_impulse *= scale;
  }
}

void limit_carried_impulses(WorldState& world, const ContactStep& step, Index contact) {
  limit_impulse_energy(world, step, world.solve_order.places_of(contact),
                       world.pairs.impulse_energy[contact]);
}

}  // namespace cs550
