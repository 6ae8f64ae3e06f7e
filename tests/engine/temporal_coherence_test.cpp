// Temporal coherence: kept answers against the separation by brute force in double precision, on
// prescribed trajectories and in scenes.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/pairs/temporal_coherence.hpp"
#include "engine/pairs_of_contacts.hpp"
#include "engine/test_bodies.hpp"
#include "engine/world/stages.hpp"
#include "helpers/exact_separation.hpp"

namespace cs550 {
namespace {

using namespace test;

/// How the second body of a pair moves past the first.
struct Trajectory {
  const char* name;
  Real speed;  ///< m/s
  Real spin;   ///< rad/s, of each body
  Real place;  ///< distance from the world's origin (m)
  int steps;
  Real least_kept;     ///< fraction of the steps in which a contact is kept
  int least_retested;  ///< steps in which a face was retested, and steps in which edges were
};

constexpr Trajectory trajectories[] = {
    {"at rest", 0, 0, 0, 10, Real(0.5), 0},
    {"slow", Real(0.004), Real(0.002), 0, 80, Real(0.5), 80},
    {"creeping", Real(0.015), Real(0.01), 0, 80, Real(0.1), 300},
    {"turning", 0, Real(0.03), 0, 80, Real(0.1), 500},
    {"fast", 6, 1, 0, 10, 0, 50},
    {"spinning", Real(0.1), 20, 0, 30, 0, 150},
    {"slow and far", Real(0.004), Real(0.002), 2000, 80, Real(0.1), 80},
    {"creeping and far", Real(0.015), Real(0.01), 2000, 40, 0, 150},
};

/// Boxes, hulls, a plate, a needle and shapes with few corners, all about a metre in size.
std::vector<ShapePtr> shapes_of_all_kinds() {
  Random random(71);
  return {box_shape(Vec3::Constant(Real(0.5))),
          box_shape({Real(0.5), Real(0.4), Real(0.3)}),
          box_shape({Real(0.5), Real(0.5), Real(0.02)}),
          box_shape({Real(0.02), Real(0.02), Real(0.8)}),
          shape_of(prism_soup(5, Real(0.5), Real(0.4))),
          shape_of(tetrahedron_soup(1)),
          random_hull(random, 8, Vec3::Constant(Real(0.5))),
          random_hull(random, 14, {Real(0.6), Real(0.5), Real(0.3)})};
}

/// Two bodies on prescribed trajectories: before each step they are placed anew, with the velocities
/// that lead to the next place.
class MovingPair {
 public:
  MovingPair(const ShapePtr& a, const ShapePtr& b, const Trajectory& trajectory, Random& random)
      : trajectory_(trajectory) {
    world_.settings().gravity.setZero();
    radius_ = std::min(a->radius, b->radius);
    origin_ = trajectory.place * random.unit_vector();
    turn_a_ = random.orientation();
    turn_b_ = random.orientation();
    spin_a_ = trajectory.spin * random.unit_vector();
    spin_b_ = trajectory.spin * random.unit_vector();
    heading_ = trajectory.speed * random.unit_vector();
    a_ = world_.add_body(body_at(a, origin_));
    b_ = world_.add_body(body_at(b, origin_));
    offset_ = touching_offset(random);
  }

  void step(int number) {
    const int middle = trajectory_.steps / 2;
    const Real time = static_cast<Real>(number - middle) * step_length;
    place(a_, origin_, turn_a_, spin_a_, Vec3::Zero(), time);
    place(b_, origin_ + offset_, turn_b_, spin_b_, heading_, time);
    pose_a_ = world_.posed_shape(a_);
    pose_b_ = world_.posed_shape(b_);
    world_.step(step_length);
  }

  /// The separation in truth at the poses for which the last step detected contacts (m).
  double separation() const {
    const ExactBody exact_a(pose_a_, pose_a_.pose.position);
    const ExactBody exact_b(pose_b_, pose_a_.pose.position);
    return best_separations(exact_a, exact_b).largest();
  }

  const World& world() const { return world_; }
  double radius() const { return double{radius_}; }
  /// The farthest that the surfaces approach each other in a step (m).
  double reach() const {
    const Real turning = trajectory_.spin * (world_.shape(a_)->radius + world_.shape(b_)->radius);
    return double{step_length * (trajectory_.speed + turning)};
  }
  const Contact* contact() const {
    return world_.contacts().empty() ? nullptr : &world_.contacts()[0];
  }

 private:
  static Quat turned(const Quat& start, const Vec3& spin, Real time) {
    const Real angle = spin.norm() * time;
    return (Quat(Eigen::AngleAxis<Real>(angle, any_direction(spin))) * start).normalized();
  }
  static Vec3 any_direction(const Vec3& v) { return v.norm() > 0 ? v.normalized() : Vec3::UnitX(); }

  void place(BodyId id, const Vec3& middle, const Quat& turn, const Vec3& spin,
             const Vec3& velocity, Real time) {
    RigidBody& body = world_.body(id);
    body.pose = {middle + time * velocity, turned(turn, spin, time)};
    set_velocity(body, velocity, spin);
  }

  /// An offset in a random direction at which the bodies overlap by up to a few per cent, or are
  /// apart by as little.
  Vec3 touching_offset(Random& random) const {
    const Vec3 way = random.unit_vector();
    PosedShape a = world_.posed_shape(a_);
    PosedShape b = world_.posed_shape(b_);
    a.pose = {Vec3::Zero(), turn_a_};
    Real near = 0;
    Real far = a.shape->radius + b.shape->radius;
    for (int i = 0; i < 30; ++i) {
      const Real middle = (near + far) / 2;
      b.pose = {middle * way, turn_b_};
      (overlap(a, b) ? near : far) = middle;
    }
    return (near + random.real(Real(-0.04), Real(0.02)) * radius_) * way;
  }

  World world_;
  Trajectory trajectory_;
  Real radius_ = 0;
  Vec3 origin_;
  Vec3 offset_;
  Vec3 heading_;
  Vec3 spin_a_;
  Vec3 spin_b_;
  Quat turn_a_;
  Quat turn_b_;
  BodyId a_;
  BodyId b_;
  PosedShape pose_a_;
  PosedShape pose_b_;
};

double deepest(const Manifold& manifold) {
  double deepest = HUGE_VAL;
  for (const ContactPoint& point : manifold.points) {
    deepest = std::min(deepest, double{point.separation});
  }
  return deepest;
}

/// How many answers of the steps were kept, and how many were retested: those of faces, and those of edges.
struct Answers {
  int kept = 0;
  int retested_faces = 0;
  int retested_edges = 0;
};

/// Follows a pair and compares each step with the truth.
Answers follow(MovingPair& pair, int steps) {
  // Half the stated error of 1e-3 of the diameter each: for the bodies, and for the points.
  const double half_of_stated = 1e-3 * pair.radius();
  const double rounding = 1e-5;  // of float at these sizes, in a margin and in a separation (m)
  const double tie = double{tie_tolerance} * pair.radius();
  Answers answers;
  double deepest_of_query = 0;
  for (int step = 0; step < steps; ++step) {
    pair.step(step);
    const Contact* contact = pair.contact();
    const double truth = pair.separation();
    const bool touches = contact != nullptr && !contact->manifold.points.empty();
    EXPECT_TRUE(touches || truth > pair.reach() - rounding)
        << "missed a contact at step " << step << ", separation " << truth;
    if (!touches) continue;

    const StepStats& stats = pair.world().stats();
    const double separation_of_query = double{pair.world().axes()[0].separation};
    if (stats.kept == 0) {
      deepest_of_query = deepest(contact->manifold);
      if (stats.retested == 0) continue;
      const bool are_edges = pair.world().axes()[0].feature == AxisFeature::Edges;
      ++(are_edges ? answers.retested_edges : answers.retested_faces);
      EXPECT_LE(separation_of_query, truth + rounding) << "step " << step;
      EXPECT_GE(separation_of_query, truth - tie - rounding) << "step " << step;
      continue;
    }
    ++answers.kept;
    if (truth < 0) {
      EXPECT_NEAR(truth, separation_of_query, half_of_stated + tie + rounding) << "step " << step;
    }
    EXPECT_NEAR(deepest(contact->manifold), deepest_of_query, half_of_stated + rounding)
        << "step " << step;
  }
  return answers;
}

class TemporalCoherenceOnTrajectories : public testing::TestWithParam<Trajectory> {};

TEST_P(TemporalCoherenceOnTrajectories, KeptContactsHaveTheStatedErrorLong) {
  const Trajectory& trajectory = GetParam();
  const std::vector<ShapePtr> shapes = shapes_of_all_kinds();
  Random random(72);
  int kept = 0;
  int retested_faces = 0;
  int retested_edges = 0;
  int steps = 0;
  for (const ShapePtr& a : shapes) {
    for (const ShapePtr& b : shapes) {
      MovingPair pair(a, b, trajectory, random);
      SCOPED_TRACE(testing::Message() << trajectory.name << ", " << a->mesh.vertex_count()
                                      << " and " << b->mesh.vertex_count() << " vertices");
      const Answers answers = follow(pair, trajectory.steps);
      kept += answers.kept;
      retested_faces += answers.retested_faces;
      retested_edges += answers.retested_edges;
      steps += trajectory.steps;
    }
  }
  EXPECT_GE(kept, trajectory.least_kept * Real(steps)) << "too little was kept to test";
  EXPECT_GE(retested_faces, trajectory.least_retested) << "too few faces were retested to test";
  EXPECT_GE(retested_edges, trajectory.least_retested) << "too few edges were retested to test";
}

INSTANTIATE_TEST_SUITE_P(All, TemporalCoherenceOnTrajectories, testing::ValuesIn(trajectories));

TEST(TemporalCoherence, SwitchedOffItKeepsNothing) {
  World world = falling_hulls(8, 73);
  world.settings().temporal_coherence = false;
  for (int step = 0; step < 120; ++step) {
    world.step(step_length);
    ASSERT_EQ(world.stats().kept, 0);
    ASSERT_EQ(world.stats().retested, 0);
  }
}

// While it is off, the cube comes so near that a query finds points for the first time. Wall and cube are turned, so
// that their bounds overlap and are queried before that.
TEST(TemporalCoherence, SwitchedOnAgainItKnowsTheLastQuery) {
  const Quat turn(Eigen::AngleAxis<Real>(Real(0.5), Vec3::UnitZ()));
  const auto turned = [&](BodyDef def) {
    def.pose = {turn * def.pose.position, turn};
    return def;
  };
  World world;
  world.settings().check_stages = true;
  world.add_body(floor_body());
  world.add_body(
      turned(body_at(box_shape({Real(0.5), 2, 2}), {Real(-0.5), 0, 2}, BodyKind::Static)));
  const BodyId cube = world.add_body(
      turned(body_at(box_shape(Vec3::Constant(Real(0.5))), {Real(0.5068), 0, Real(0.5)})));
  world.step(step_length);
  ASSERT_EQ(world.stats().points, 4) << "on the floor";
  world.settings().temporal_coherence = false;
  world.body(cube).pose.position -= turn * Vec3(Real(2e-4), 0, 0);
  world.step(step_length);
  ASSERT_EQ(world.stats().points, 8) << "four on the floor, and four at the wall";
  world.settings().temporal_coherence = true;
  world.step(step_length);
  EXPECT_TRUE(world.problems().empty()) << world.problems()[0].message;
  EXPECT_GT(world.stats().deepest_separation, Real(-0.001));
  EXPECT_LT(world.body(cube).linear_velocity.norm(), Real(0.01));
}

TEST(TemporalCoherence, FreshQueriesAgreeInEveryStepOfAPile) {
  World world = falling_hulls(20, 74);
  world.settings().check_stages = true;
  for (int step = 0; step < 400; ++step) {
    world.step(step_length);
    ASSERT_TRUE(world.problems().empty()) << world.problems()[0].message;
  }
  EXPECT_GT(world.stats().contacts, 20);
  EXPECT_GT(2 * world.stats().kept, world.stats().pairs) << "a resting pile keeps most answers";
  EXPECT_GT(world.stats().deepest_separation, Real(-0.01));
}

/// Seen from the floor, rounding is as large as what a retest allows.
TEST(TemporalCoherence, FreshQueriesAgreeForSmallBodiesOnALargeFloor) {
  Random random(76);
  World world;
  world.settings().length_unit = Real(0.05);
  world.settings().check_stages = true;
  world.add_body(floor_body(100));
  for (int i = 0; i < 20; ++i) {
    const ShapePtr shape = random_hull(random, 16, Vec3::Constant(Real(0.02)));
    BodyDef def = body_at(shape, {random.real(0, 90), random.real(0, 90), Real(0.05)});
    def.pose.orientation = random.orientation();
    def.linear_velocity = Real(0.3) * random.unit_vector();
    world.add_body(def);
  }
  int retested = 0;
  for (int step = 0; step < 200; ++step) {
    world.step(step_length);
    ASSERT_TRUE(world.problems().empty()) << world.problems()[0].message;
    retested += world.stats().retested;
  }
  EXPECT_EQ(world.stats().contacts, 20);
  EXPECT_GT(retested, 150) << "too little was retested to test";
  EXPECT_GT(world.stats().deepest_separation, Real(-0.001));
}

TEST(TemporalCoherence, CopyContinuesToTheLastBit) {
  World world = falling_hulls(12, 75);
  run(world, 150);
  ASSERT_GT(world.stats().kept, 5);
  World copy = world;
  for (int step = 0; step < 100; ++step) {
    for (World* each : {&world, &copy}) each->step(step_length);
    ASSERT_EQ(copy.state_hash(), world.state_hash()) << "step " << step;
  }
}

/// A box that rests on the floor, with its contact kept.
World resting_box() {
  World world;
  world.add_body(floor_body());
  world.add_body(body_at(box_shape(Vec3::Constant(Real(0.5))), {0, 0, Real(0.5)}));
  run(world, 60);
  return world;
}

TEST(TemporalCoherence, AKeptContactCarriesTheWeight) {
  World world = resting_box();
  ASSERT_EQ(world.stats().kept, 1);
  const Manifold before = world.contacts()[0].manifold;
  run(world, 1);
  const Manifold& now = world.contacts()[0].manifold;
  ASSERT_EQ(now.points.size(), before.points.size());
  Real impulse = 0;
  for (Index i = 0; i < now.points.size(); ++i) {
    EXPECT_EQ(now.points[i].feature, before.points[i].feature);
    impulse += now.points[i].normal_impulse;
  }
  const Real substep = step_length / static_cast<Real>(world.settings().substeps);
  EXPECT_NEAR(impulse, 1000 * Real(9.81) * substep, Real(0.2));
}

// A retest stores the pose as a full query does.
TEST(TemporalCoherence, AContactIsKeptAfterARetest) {
  const ShapePtr prism = shape_of(prism_soup(6, Real(0.5), Real(0.5)));
  World world;
  world.add_body(body_at(prism, {0, 0, Real(-0.5)}, BodyKind::Static));
  const BodyId id = world.add_body(body_at(prism, {0, 0, Real(0.5)}));
  Pose place = world.body(id).pose;
  const auto step_at_place = [&] {
    world.body(id).pose = place;
    set_velocity(world.body(id), Vec3::Zero(), Vec3::Zero());
    world.step(step_length);
  };
  step_at_place();
  for (int i = 0; i < 10; ++i) {
    place.position.x() += 2 * kept_motion * prism->radius;
    step_at_place();
    EXPECT_EQ(world.stats().retested, 1);
    EXPECT_EQ(world.stats().kept, 0);
    step_at_place();
    EXPECT_EQ(world.stats().kept, 1);
  }
}

TEST(TemporalCoherence, ABodyThatIsMovedAwayLosesItsContact) {
  World world = resting_box();
  world.body(world.id_at(1)).pose.position.z() += Real(0.05);
  run(world, 1);
  EXPECT_EQ(world.stats().contacts, 0);
}

TEST(TemporalCoherence, ChecksReportAnAnswerThatNoLongerHolds) {
  WorldState state;
  state.pairs = pairs_of(std::vector{Contact{0, 1, {}, 0, 0}});
  state.pairs.answers[0] = PairAnswer::Kept;
  for (int i = 0; i < 2; ++i) {
    state.bodies.emplace_back();
    state.slots.emplace_back();
    state.definitions.push_back(body_at(box_shape(Vec3::Ones()), Vec3::Zero()));
  }
  check_kept_answers(state, step_length);
  ASSERT_EQ(state.problems.size(), 1U) << "bodies at one place, kept apart";
  EXPECT_NE(state.problems[0].message.find("overlap were kept apart"), std::string::npos);
}

}  // namespace
}  // namespace cs550
