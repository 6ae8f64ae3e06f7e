/// Which long tests wait for short ones.
#include "cli/grading/long_tests.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using cs550::cli::GradedTest;
using cs550::cli::long_tests;
using cs550::cli::LongTests;
using cs550::cli::Verdict;
using Kind = cs550::cli::Verdict::Kind;

const GradedTest tower{"Tower", "L7.8", 2, true};

Verdict short_test(const char* step, Kind kind) { return {{"A", step, 1, false}, kind, "", 0}; }

TEST(LongTests, WaitForTheShortTestsOfTheirStepAndOfEarlierOnes) {
  for (const char* step : {"L7.3", "L7.8"}) {
    const LongTests tests = long_tests(
        {tower}, {short_test("L7.1", Kind::Passed), short_test(step, Kind::Failed)}, false);
    EXPECT_TRUE(tests.ready.empty());
    ASSERT_EQ(tests.waiting.size(), 1U);
    const Verdict& verdict = tests.waiting.front();
    EXPECT_EQ(verdict.test.name, "Tower");
    EXPECT_EQ(verdict.kind, Kind::Blocked);
    EXPECT_EQ(verdict.step_to_mend(), step);
    EXPECT_EQ(verdict.earned(), 0);
    EXPECT_FALSE(verdict.is_blocked_by_other_lab());
  }
}

TEST(LongTests, RunIfLaterStepsFailOrAnEarlierLabBlocks) {
  for (const Verdict& verdict :
       {short_test("L7.9", Kind::Failed), short_test("L7.8", Kind::Blocked)}) {
    const LongTests tests = long_tests({tower}, {verdict}, false);
    EXPECT_EQ(tests.ready.size(), 1U);
    EXPECT_TRUE(tests.waiting.empty());
  }
}

TEST(LongTests, AllRunIfEverythingIsAskedFor) {
  const LongTests tests = long_tests({tower}, {short_test("L7.1", Kind::Failed)}, true);
  EXPECT_EQ(tests.ready.size(), 1U);
  EXPECT_TRUE(tests.waiting.empty());
}

}  // namespace
