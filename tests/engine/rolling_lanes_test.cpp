// Rolling resistance of many contacts: the engine's kernel must give the same bits as one contact after
// another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/contacts/solve_order.hpp"
#include "engine/guarded_bodies.hpp"
#include "engine/kernel_forms.hpp"
#include "engine/pairs_of_contacts.hpp"

namespace cs550::test {
namespace {

/// Contacts of one to four points with loads, some of them zero, in the order of the world.
struct RollingSystem {
  std::vector<Contact> contacts;
  SolveOrder order;
  std::vector<ContactConstraint> constraints;
  std::vector<SolverBody> bodies;
};

RollingSystem random_rolling_system(Random& random) {
  RollingSystem system;
  const Index count = random.integer(2, 40);
  const Index movable = std::max(Index(1), count * 4 / 5);
  std::vector<RigidBody> kinds(count);
  for (Index i = 0; i < count; ++i) {
    kinds[i].kind = i < movable ? BodyKind::Dynamic : BodyKind::Static;
    system.bodies.push_back(random_body(random, i < movable));
    if (random.real(0, 1) < Real(0.2)) system.bodies.back().w.setZero();
  }
  for (Index i = random.integer(0, 100); i > 0; --i) {
    Contact contact;
    contact.body_a = random.integer(0, movable - 1);
    contact.body_b = random.integer(0, count - 1);
    for (Index k = random.integer(1, 4); k > 0; --k) {
      contact.manifold.points.push_back({});
      contact.manifold.points.back().normal_impulse = std::max(Real(0), random.real(-1, 2));
    }
    if (contact.body_a != contact.body_b) system.contacts.push_back(contact);
  }
  arrange_constraints(pairs_of(system.contacts), kinds, Vec3(0, 0, Real(-9.81)), system.order);
  system.constraints.resize(system.order.place_of_point.size());
  for (const Index i : system.order.contacts) {
    const Contact& contact = system.contacts[i];
    auto place = system.order.places_of(i).begin();
    for (const ContactPoint& point : contact.manifold.points) {
      ContactConstraint& constraint = system.constraints[*place++];
      constraint.body_a = contact.body_a;
      constraint.body_b = contact.body_b;
      constraint.normal_impulse = point.normal_impulse;
    }
  }
  return system;
}

/// Friction against relative rotation: it takes energy, never reverses the rotation, and is at most
/// the lever times the load. @returns how many contacts it brought to rest
int resist_one_by_one(RollingSystem& system, Real lever) {
  int stopped = 0;
  for (const Contact& contact : system.contacts) {
    Real load = 0;
    for (const ContactPoint& point : contact.manifold.points) load += point.normal_impulse;
    SolverBody& a = system.bodies[contact.body_a];
    SolverBody& b = system.bodies[contact.body_b];
    const Vec3 relative = b.w - a.w;
    const Real speed = relative.norm();
    if (speed == 0) continue;
    const Vec3 axis = relative / speed;
    const Vec3 response_a = a.world_inverse_inertia * axis;
    const Vec3 response_b = b.world_inverse_inertia * axis;
    const Real response = axis.dot(response_a + response_b);
    if (response <= 0) continue;
    if (speed / response < lever * load) ++stopped;
    const Real impulse = std::min(lever * load, speed / response);
    a.w += impulse * response_a;
    b.w -= impulse * response_b;
  }
  return stopped;
}

using ResistRolling = void(ConstraintMirror&, const SolveOrder&, std::span<const ContactConstraint>,
                           std::span<SolverBody>, Real);

/// Passes bring the mirror up to date for the resistance.
struct RollingForm {
  const char* name;
  RunPasses* run_passes;
  ResistRolling* resist_rolling;
};

TEST(RollingInLanes, LeavesTheBitsOfOneContactAfterTheOther) {
  std::vector<RollingForm> forms;
  forms.push_back({"the engine's", &run_passes, &resist_rolling});
  if (lanes_of_four::resist_rolling != nullptr) {
    forms.push_back({"four", &lanes_of_four::run_passes, &lanes_of_four::resist_rolling});
  }
#if CS550_HAS_AVX2_FORMS
  if (lanes_of_eight::resist_rolling != nullptr && has_avx2()) {
    forms.push_back({"eight", &lanes_of_eight::run_passes, &lanes_of_eight::resist_rolling});
  }
#endif
  int stopped = 0;
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const RollingSystem system = random_rolling_system(random);
    RollingSystem one_by_one = system;
    stopped += resist_one_by_one(one_by_one, Real(0.3));
    for (const RollingForm& form : forms) {
      SCOPED_TRACE(form.name);
      std::vector<SolverBody> bodies = system.bodies;
      std::vector<ContactConstraint> constraints = system.constraints;
      ConstraintMirrors mirrors;
      keep_groups(system.order, mirrors);
      ConstraintMirror& mirror = mirrors.of_units.front();
      form.run_passes(mirror, constraints, bodies, {}, {});
      if (form.resist_rolling == &resist_rolling && !passes_spare_immovable_bodies()) {
        form.resist_rolling(mirror, system.order, constraints, bodies, Real(0.3));
      } else {
        const GuardedBodies guarded(bodies);
        form.resist_rolling(mirror, system.order, constraints, guarded.bodies(), Real(0.3));
        bodies.assign(guarded.bodies().begin(), guarded.bodies().end());
      }
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        SCOPED_TRACE("body " + std::to_string(i));
        ASSERT_TRUE(same_bits(bodies[i].w, one_by_one.bodies[i].w));
        ASSERT_TRUE(same_bits(bodies[i].v, one_by_one.bodies[i].v));
      }
    }
  }
  EXPECT_GT(stopped, 100) << "the systems no longer try contacts that stop";
}

}  // namespace
}  // namespace cs550::test
