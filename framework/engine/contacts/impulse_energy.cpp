/// @file impulse_energy.cpp
/// What carried impulses are worth.
///
/// Warm starting assumes that a substep needs the impulses of the last one. An impulse λ at a
/// constraint of effective mass m gives bodies at rest the kinetic energy λ²/2m. If m has become much
/// smaller since, because a needle has turned or because a corner has passed its impulse on to another
/// corner, the same impulse throws the bodies apart. The passes of a substep are too few to take that
/// back, and the next step would carry even more.

#include <Eigen/LU>
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
  const Eigen::Matrix2d mass = constraint.tangent_mass.cast<double>();
  if (mass.determinant() > 0) {
    const Eigen::Vector2d impulse = constraint.tangent_impulse.cast<double>();
    energy += impulse.dot(mass.inverse() * impulse) / 2;
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
  if (now <= std::max(allowed_growth * before, push_energy(world, step, places))) return;
  const auto scale = static_cast<Real>(std::sqrt(before / now));
  for (const Index place : places) {
    world.constraints[place].normal_impulse *= scale;
    world.constraints[place].tangent_impulse *= scale;
  }
}

void limit_carried_impulses(WorldState& world, const ContactStep& step) {
  auto before = world.pairs.impulse_energy.begin();
  for_constraints_of_contacts(world, [&](const Contact&, std::span<const Index> places) {
    limit_impulse_energy(world, step, places, *before++);
  });
}

}  // namespace cs550
