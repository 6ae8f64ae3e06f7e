// Passes over many constraints: the engine's kernel must give the same bits as solving one
// constraint after another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/guarded_bodies.hpp"
#include "engine/kernel_forms.hpp"

namespace cs550 {

namespace test {
namespace {

struct System {
  std::vector<SolverBody> bodies;
  std::vector<ContactConstraint> constraints;
  std::vector<bool> loaded = {};  ///< by the last warm start
};

/// All kinds of constraints: separated and penetrating, with and without load, rough and smooth.
ContactConstraint random_constraint(Random& random, Index a, Index b) {
  ContactConstraint constraint;
  constraint.body_a = a;
  constraint.body_b = b;
  constraint.n = random.unit_vector();
  constraint.u = constraint.n.unitOrthogonal();
  constraint.r_a = random.real(Real(0.2), 1) * random.unit_vector();
  constraint.r_b = random.real(Real(0.2), 1) * random.unit_vector();
  constraint.separation = random.real(Real(-0.05), Real(0.02));
  constraint.friction = random.real(0, 1) < Real(0.2) ? 0 : random.real(0, 2);
  constraint.restitution = random.real(0, 1) < Real(0.5) ? 0 : random.real(0, 1);
  constraint.approach_velocity = random.real(-3, 1);
  constraint.impact_handled = random.real(0, 1) < Real(0.5);
  if (random.real(0, 1) < Real(0.7)) {
    constraint.normal_impulse = random.real(0, 2);
    constraint.tangent_impulse = {random.real(-1, 1), random.real(-1, 1)};
  }
  return constraint;
}

/// Random bodies, the last fifth of them immovable, and constraints between pairs with at least one
/// movable body.
System random_system(Random& random, const ContactStep& step) {
  System system;
  const Index bodies = random.integer(2, 40);
  const Index movable = std::max(Index(1), bodies * 4 / 5);
  for (Index i = 0; i < bodies; ++i) system.bodies.push_back(random_body(random, i < movable));
  for (Index i = random.integer(0, 100); i > 0; --i) {
    const Index a = random.integer(0, movable - 1);
    const Index b = random.integer(0, bodies - 1);
    if (a != b) system.constraints.push_back(random_constraint(random, a, b));
  }
  system.loaded.assign(system.constraints.size(), false);
  prepare_contacts(system.constraints, system.bodies, step);
  return system;
}

void warm_start_one_by_one(System& system) {
  for (std::size_t i = 0; i < system.constraints.size(); ++i) {
    const ContactConstraint& constraint = system.constraints[i];
    warm_start(constraint, system.bodies[constraint.body_a], system.bodies[constraint.body_b]);
    system.loaded[i] = constraint.normal_impulse > 0;
  }
}

/// L7.8 as its contract specifies it, with the functions of L7.6 and L7.7. The normals of loaded constraints
/// are over-relaxed.
void solve_one_by_one(System& system, const ContactStep& step, Real over_relaxation) {
  const std::size_t count = system.constraints.size();
  for (std::size_t visit = 0; visit < count; ++visit) {
    const std::size_t i = step.backwards ? count - 1 - visit : visit;
    ContactConstraint& constraint = system.constraints[i];
    SolverBody& a = system.bodies[constraint.body_a];
    SolverBody& b = system.bodies[constraint.body_b];
    const Real mass = constraint.normal_mass;
    if (step.backwards) solve_friction(constraint, a, b);
    if (system.loaded[i]) constraint.normal_mass = mass * over_relaxation;
    solve_normal(constraint, a, b, step);
    constraint.normal_mass = mass;
    if (!step.backwards) solve_friction(constraint, a, b);
  }
}

void run_one_by_one(System& system, ContactStep step, const Passes& passes) {
  if (passes.warm_start) warm_start_one_by_one(system);
  for (int pass = 0; pass < passes.count; ++pass) {
    step.backwards = passes.goes_backwards(pass);
    solve_one_by_one(system, step, passes.over_relaxation);
  }
  if (!passes.mark_impacts) return;
  for (ContactConstraint& constraint : system.constraints) constraint.mark_impact();
}

ContactStep step_of(ContactModel model, bool use_bias) {
  ContactStep step;
  step.h = Real(1) / 240;
  step.model = model;
  step.use_bias = use_bias;
  step.soft = soft_contact(30, 4, step.h);
  step.soft_static = soft_contact(60, 2, step.h);
  step.slop = Real(0.005);
  step.max_push_speed = 3;
  step.restitution_threshold = 1;
  return step;
}

/// Both forms of the kernel as far as they exist, and the one that the engine chooses.
std::vector<std::pair<const char*, RunPasses*>> forms() {
  std::vector<std::pair<const char*, RunPasses*>> forms;
  forms.emplace_back("the engine's", &run_passes);
  if (lanes_of_four::run_passes != nullptr) forms.emplace_back("four", &lanes_of_four::run_passes);
#if CS550_HAS_AVX2_FORMS
  if (lanes_of_eight::run_passes != nullptr && has_avx2()) {
    forms.emplace_back("eight", &lanes_of_eight::run_passes);
  }
#endif
  return forms;
}

void expect_same_bits(const System& actual, const System& expected) {
  for (std::size_t i = 0; i < expected.constraints.size(); ++i) {
    SCOPED_TRACE("constraint " + std::to_string(i));
    const ContactConstraint& constraint = actual.constraints[i];
    const ContactConstraint& alone = expected.constraints[i];
    ASSERT_TRUE(same_bits(constraint.normal_impulse, alone.normal_impulse));
    ASSERT_TRUE(same_bits(constraint.tangent_impulse, alone.tangent_impulse));
    ASSERT_EQ(constraint.impact_handled, alone.impact_handled);
  }
  for (std::size_t i = 0; i < expected.bodies.size(); ++i) {
    SCOPED_TRACE("body " + std::to_string(i));
    ASSERT_TRUE(same_bits(actual.bodies[i].v, expected.bodies[i].v));
    ASSERT_TRUE(same_bits(actual.bodies[i].w, expected.bodies[i].w));
  }
}

/// How many constraints slide, and how many stick under load.
struct Tried {
  int slide = 0;
  int stick = 0;

  void count(const System& system) {
    for (const ContactConstraint& constraint : system.constraints) {
      const Real limit = constraint.friction * constraint.normal_impulse;
      const bool slides = limit > 0 && constraint.tangent_impulse.norm() > Real(0.999) * limit;
      if (slides) ++slide;
      if (!slides && constraint.normal_impulse > 0) ++stick;
    }
  }
};

void expect_equal_forms(const ContactStep& step, const Passes& passes, Tried& tried) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const System system = random_system(random, step);
    System one_by_one = system;
    run_one_by_one(one_by_one, step, passes);
    tried.count(one_by_one);
    for (const auto& [form, run] : forms()) {
      SCOPED_TRACE(form);
      System at_once = system;
      ConstraintMirror mirror;
      run(mirror, at_once.constraints, at_once.bodies, step, passes);
      expect_same_bits(at_once, one_by_one);
    }
  }
}

TEST(Passes, LeaveTheBitsOfOneConstraintAfterTheOther) {
  Tried tried;
  for (const ContactModel model : {ContactModel::Soft, ContactModel::Baumgarte}) {
    for (const bool use_bias : {true, false}) {
      for (const Passes& passes :
           {Passes{false, 1}, Passes{false, 1, true}, Passes{true, 3}, Passes{true, 3, true, false},
            Passes{false, 0, false, true, true}, Passes{false, 2, true, true, true},
            Passes{.warm_start = true, .count = 2, .over_relaxation = Real(1.3)},
            Passes{.count = 2, .over_relaxation = Real(1.3)}}) {
        expect_equal_forms(step_of(model, use_bias), passes, tried);
      }
    }
  }
  EXPECT_GT(tried.slide, 1000) << "the systems no longer try contacts that slide";
  EXPECT_GT(tried.stick, 1000) << "the systems no longer try contacts that stick";
}

using PrepareContacts = void(std::span<ContactConstraint>, std::span<const SolverBody>,
                             const ContactStep&);

std::vector<std::pair<const char*, PrepareContacts*>> forms_of_preparing() {
  std::vector<std::pair<const char*, PrepareContacts*>> forms;
  forms.emplace_back("the engine's", &prepare_contacts);
  if (lanes_of_four::prepare_contacts != nullptr) {
    forms.emplace_back("four", &lanes_of_four::prepare_contacts);
  }
#if CS550_HAS_AVX2_FORMS
  if (lanes_of_eight::prepare_contacts != nullptr && has_avx2()) {
    forms.emplace_back("eight", &lanes_of_eight::prepare_contacts);
  }
#endif
  return forms;
}

/// K = JM⁻¹Jᵀ of both tangents, in double precision.
Eigen::Matrix2d tangent_response(const ContactConstraint& constraint, const SolverBody& a,
                                 const SolverBody& b) {
  Eigen::Matrix<double, 2, 12> jacobian;
  Eigen::Matrix<double, 12, 12> inverse_mass = Eigen::Matrix<double, 12, 12>::Zero();
  const Vec3 directions[] = {constraint.u, constraint.v()};
  for (int row = 0; row < 2; ++row) {
    const Eigen::Vector3d d = directions[row].cast<double>();
    jacobian.row(row) << -d.transpose(), -constraint.r_a.cast<double>().cross(d).transpose(),
        d.transpose(), constraint.r_b.cast<double>().cross(d).transpose();
  }
  inverse_mass.diagonal().segment<3>(0).setConstant(a.inverse_mass);
  inverse_mass.block<3, 3>(3, 3) = a.world_inverse_inertia.cast<double>();
  inverse_mass.diagonal().segment<3>(6).setConstant(b.inverse_mass);
  inverse_mass.block<3, 3>(9, 9) = b.world_inverse_inertia.cast<double>();
  return jacobian * inverse_mass * jacobian.transpose();
}

TEST(Passes, MassesAreThoseOfEachConstraint) {
  const ContactStep step = step_of(ContactModel::Soft, true);
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const System system = random_system(random, step);
    for (const auto& [form, prepare] : forms_of_preparing()) {
      SCOPED_TRACE(form);
      System prepared = system;
      for (ContactConstraint& constraint :
           prepared.constraints) {  // random_system() has prepared them
        constraint.normal_mass = -1;
        constraint.tangent_mass.setConstant(-1);
        constraint.softness = {-1, -1, -1};
      }
      prepare(prepared.constraints, prepared.bodies, step);
      for (const ContactConstraint& constraint : prepared.constraints) {
        const SolverBody& a = prepared.bodies[constraint.body_a];
        const SolverBody& b = prepared.bodies[constraint.body_b];
        const ContactJacobian normal =
            contact_jacobian(constraint.n, constraint.r_a, constraint.r_b);
        ASSERT_TRUE(same_bits(constraint.normal_mass, constraint_mass(normal, a, b)));
        // Well conditioned: the inertias of a body differ by less than 6. A few roundings.
        const Eigen::Matrix2d product =
            constraint.tangent_mass.cast<double>() * tangent_response(constraint, a, b);
        ASSERT_NEAR((product - Eigen::Matrix2d::Identity()).norm(), 0, 1e-5);
        const bool on_immovable = a.inverse_mass == 0 || b.inverse_mass == 0;
        const Softness& softness = on_immovable ? step.soft_static : step.soft;
        ASSERT_EQ(constraint.softness.bias_rate, softness.bias_rate);
        ASSERT_EQ(constraint.softness.mass_scale, softness.mass_scale);
        ASSERT_EQ(constraint.softness.impulse_scale, softness.impulse_scale);
      }
    }
  }
}

TEST(Passes, AStaleMirrorIsBuiltAgain) {
  Random random(1);
  const ContactStep step = step_of(ContactModel::Soft, true);
  System system = random_system(random, step);
  ASSERT_FALSE(system.constraints.empty());
  ConstraintMirror mirror;
  run_passes(mirror, system.constraints, system.bodies, step, {false, 1});
  for (ContactConstraint& constraint : system.constraints) constraint.normal_mass *= 2;
  mirror.stale = true;
  System one_by_one = system;
  run_passes(mirror, system.constraints, system.bodies, step, {true, 2});
  run_one_by_one(one_by_one, step, {true, 2});
  expect_same_bits(system, one_by_one);
}

TEST(Passes, ChangedImpulsesAndMarksAreReadAgain) {
  Random random(2);
  const ContactStep step = step_of(ContactModel::Soft, true);
  System system = random_system(random, step);
  ASSERT_FALSE(system.constraints.empty());
  ConstraintMirror mirror;
  run_passes(mirror, system.constraints, system.bodies, step, {true, 2});
  for (ContactConstraint& constraint : system.constraints) {
    constraint.normal_impulse += 1;
    constraint.tangent_impulse.setZero();
    constraint.impact_handled = false;
  }
  mirror.stale_impulses = true;
  System one_by_one = system;
  run_passes(mirror, system.constraints, system.bodies, step, {true, 1, true});
  run_one_by_one(one_by_one, step, {true, 1, true});
  expect_same_bits(system, one_by_one);
}

TEST(Passes, GoOnWhereTheLastPassesEnded) {
  Random random(3);
  const ContactStep step = step_of(ContactModel::Soft, true);
  System system = random_system(random, step);
  ASSERT_FALSE(system.constraints.empty());
  System one_by_one = system;
  ConstraintMirror mirror;
  for (const Passes& passes :
       {Passes{true, 0}, Passes{false, 2},
        Passes{.count = 1, .mark_impacts = true, .over_relaxation = Real(1.3)}, Passes{true, 1},
        Passes{false, 0, false, true, true}}) {
    run_passes(mirror, system.constraints, system.bodies, step, passes);
    run_one_by_one(one_by_one, step, passes);
    expect_same_bits(system, one_by_one);
  }
}

/// As in a substep: only the last passes store, or passes that do nothing else.
TEST(Passes, ImpulsesAndMarksMayStayInTheMirrorUntilTheyAreNeeded) {
  const ContactStep step = step_of(ContactModel::Soft, true);
  const Passes biased{.warm_start = true, .count = 2, .store = false};
  const Passes relaxing{.count = 1, .mark_impacts = true, .store = false};
  for (const auto& [form, run] : forms()) {
    SCOPED_TRACE(form);
    for (const Passes& last : {Passes{}, Passes{.warm_start = true}, Passes{.count = 1}}) {
      Random random(4);
      System system = random_system(random, step);
      ASSERT_FALSE(system.constraints.empty());
      System one_by_one = system;
      ConstraintMirror mirror;
      for (const Passes& passes : {biased, relaxing, biased, last}) {
        run(mirror, system.constraints, system.bodies, step, passes);
        run_one_by_one(one_by_one, step, passes);
      }
      EXPECT_FALSE(mirror.is_ahead);
      expect_same_bits(system, one_by_one);
    }
  }
}

TEST(Passes, ImpulsesThatOnlyTheMirrorHasAreForgottenWithTheConstraints) {
  const ContactStep step = step_of(ContactModel::Soft, true);
  for (const auto& [form, run] : forms()) {
    SCOPED_TRACE(form);
    Random random(5);
    System system = random_system(random, step);
    ConstraintMirror mirror;
    run(mirror, system.constraints, system.bodies, step, {.count = 2, .store = false});
    system = random_system(random, step);
    ASSERT_FALSE(system.constraints.empty());
    System one_by_one = system;
    mirror.stale = true;
    run(mirror, system.constraints, system.bodies, step, {});
    expect_same_bits(system, one_by_one);
  }
}

/// A ball whose contact with the floor is at its lowest point approaches with 1 m/s.
System falling_ball(Real load) {
  SolverBody ball;
  ball.inverse_mass = 1;
  ball.world_inverse_inertia = Mat3::Identity();
  ball.v = -Vec3::UnitZ();
  ContactConstraint constraint;
  constraint.body_a = 1;
  constraint.body_b = 0;
  constraint.n = Vec3::UnitZ();
  constraint.u = Vec3::UnitX();
  constraint.r_b = -Vec3::UnitZ();
  constraint.normal_impulse = load;
  System system{{ball, SolverBody{}}, {constraint}};
  system.loaded.assign(1, false);
  prepare_contacts(system.constraints, system.bodies, step_of(ContactModel::Soft, false));
  return system;
}

/// The change of an impulse is ω times as large, and so is that of the velocity: (1 − ω)·v is left. The warm
/// start adds the load times the inverse mass of 1/kg.
TEST(Passes, OverRelaxationReversesAPartOfTheApproachOfALoadedContact) {
  const Real load = Real(0.25);
  for (const auto& [form, run] : forms()) {
    SCOPED_TRACE(form);
    for (const Real factor : {Real(1), Real(1.3), Real(1.5)}) {
      SCOPED_TRACE(factor);
      for (const bool loaded : {false, true}) {
        System ball = falling_ball(loaded ? load : 0);
        ConstraintMirror mirror;
        const Passes passes{.warm_start = true, .count = 1, .over_relaxation = factor};
        run(mirror, ball.constraints, ball.bodies, step_of(ContactModel::Soft, false), passes);
        const Real left = loaded ? (1 - factor) * (load - 1) : 0;
        EXPECT_NEAR(ball.bodies[0].v.z(), left, 1e-6);
        EXPECT_EQ(ball.constraints[0].normal_mass, 1);
      }
    }
  }
}

TEST(Passes, LoadsAreForgottenWithTheConstraints) {
  for (const auto& [form, run] : forms()) {
    SCOPED_TRACE(form);
    System ball = falling_ball(Real(0.25));
    const ContactStep step = step_of(ContactModel::Soft, false);
    ConstraintMirror mirror;
    run(mirror, ball.constraints, ball.bodies, step, {.warm_start = true});
    mirror.stale = true;
    run(mirror, ball.constraints, ball.bodies, step, {.count = 1, .over_relaxation = Real(1.5)});
    EXPECT_NEAR(ball.bodies[0].v.z(), 0, 1e-6);
  }
}

TEST(Passes, DoNotWriteImmovableBodiesThatOtherThreadsMayRead) {
  for (const auto& [name, run_form] : forms()) {
    if (run_form == &run_passes && !passes_spare_immovable_bodies()) continue;
    SCOPED_TRACE(name);
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
      Random random(seed);
      const ContactStep step = step_of(ContactModel::Soft, true);
      System system = random_system(random, step);
      System alone = system;
      const GuardedBodies guarded(system.bodies);
      ConstraintMirror mirror;
      const Passes passes{.warm_start = true, .count = 2};
      run_form(mirror, system.constraints, guarded.bodies(), step, passes);
      run_one_by_one(alone, step, passes);
      system.bodies.assign(guarded.bodies().begin(), guarded.bodies().end());
      expect_same_bits(system, alone);
    }
  }
}

}  // namespace
}  // namespace test
}  // namespace cs550
