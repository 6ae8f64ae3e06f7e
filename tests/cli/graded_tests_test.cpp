/// Steps are sorted as the handout advises to write them, else by number.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/grading/graded_tests.hpp"

namespace {

TEST(Verdict, StepsComeInTheOrderOfTheirNumbers) {
  std::vector<std::string> steps = {"L12.10", "L12.2", "L12.1", "L12.11", "L12.9"};
  std::sort(steps.begin(), steps.end(), cs550::cli::is_earlier_step);
  EXPECT_EQ(steps, (std::vector<std::string>{"L12.1", "L12.2", "L12.9", "L12.10", "L12.11"}));
}

TEST(Verdict, StepsComeInTheOrderThatTheHandoutAdvises) {
  std::vector<std::string> steps = {"L2.4", "L2.6", "L2.5", "L2.3"};
  std::sort(steps.begin(), steps.end(), cs550::cli::is_earlier_step);
  EXPECT_EQ(steps, (std::vector<std::string>{"L2.3", "L2.5", "L2.4", "L2.6"}));
}

}  // namespace
