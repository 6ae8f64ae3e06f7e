// The contact problem on the pages of labs 6 and 7, and its error measure.
#include "pages/labs/stack_runs.hpp"

#include <gtest/gtest.h>

namespace cs550::test {
namespace {

using namespace pages;

const StackSettings stacks[] = {{1, 1, 0, 0, 0},
                                {3, 1, Real(0.2), Real(0.5), 0},
                                {5, 4, -1, Real(0.5), 0},
                                {5, 1, Real(0.2), 1, Real(0.5)}};

/// Checks the complementarity conditions, which determine the velocities.
TEST(StackAnswer, KeepsContactsFromApproachingAndNeedsNoPull) {
  for (const StackSettings& settings : stacks) {
    const Stack start = make_stack(settings);
    Stack stack = start;
    stack.bodies = frictionless_answer(start);
    for (const ContactConstraint& constraint : stack.constraints) {
      const Real before = approach_velocity(constraint, start);
      EXPECT_NEAR(approach_velocity(constraint, stack), -settings.restitution * before, 1e-6);
    }
    // Each level transmits the momentum gained by all boxes above it.
    Real gained = 0;
    for (std::size_t i = stack.bodies.size() - 1; i > 0; --i) {
      const Vec3 change = stack.bodies[i].v - start.bodies[i].v;
      EXPECT_EQ(change.head<2>().norm(), 0) << "there is no friction";
      gained += change.z() / stack.bodies[i].inverse_mass;
      EXPECT_GE(gained, 0) << "contacts do not pull";
    }
  }
}

TEST(StackAnswer, IsWhatAccumulatedImpulsesConvergeTo) {
  for (const StackSettings& settings : stacks) {
    if (settings.restitution > 0) continue;
    const Stack start = without_friction(make_stack(settings));
    const std::vector<SolverBody> answer = frictionless_answer(start);
    const StackRun run = solve_accumulating(start, 2000, {});
    EXPECT_GT(velocity_error(start, answer), 0.1) << "g·h and more";
    EXPECT_LT(velocity_error(run.back(), answer), 1e-5) << settings.boxes << " boxes";
  }
}

TEST(StackAnswer, ErrorIsASpeed) {
  const Stack start = make_stack({4, 3, 0, 0, 0});
  EXPECT_NEAR(velocity_error(start, frictionless_answer(start)), Real(9.81) * stack_step, 1e-6)
      << "all boxes fall for one step";
  EXPECT_EQ(velocity_error(start, start.bodies), 0);
}

TEST(StackAnswer, EverySolverBeginsWithTheSameError) {
  const drawing::Plot plot = compare_solvers(make_stack({}), 10);
  ASSERT_EQ(plot.series.size(), 3U);
  EXPECT_EQ(plot.series[0].values.front().y(), plot.series[1].values.front().y());
  EXPECT_LT(plot.series[2].values.front().y(), plot.series[1].values.front().y())
      << "a warm start is closer";
  EXPECT_FALSE(plot.notes.empty()) << "which says what is plotted";
}

// What the handout of lab 7 asks about: the naive solver begins faster and never arrives.
TEST(StackAnswer, AccumulatedImpulsesOvertakeThoseThatAreNeverTakenBack) {
  const drawing::Plot plot = compare_solvers(make_stack({}), 200);
  const auto& naive = plot.series[0].values;
  const auto& accumulated = plot.series[1].values;
  EXPECT_LT(naive[10].y(), accumulated[10].y());
  EXPECT_NEAR(naive[200].y(), naive[100].y(), Real(0.01) * naive[100].y()) << "it stands still";
  EXPECT_LT(accumulated[200].y(), Real(1e-3) * naive[200].y());
}

TEST(StackAnswer, WhereBoxesBounceOnlyTheNaiveSolverIsCompared) {
  StackSettings settings;
  settings.restitution = Real(0.5);
  EXPECT_EQ(compare_solvers(make_stack(settings), 10).series.size(), 1U);
}

}  // namespace
}  // namespace cs550::test
