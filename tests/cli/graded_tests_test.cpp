/// Steps are sorted by number, not alphabetically.
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

}  // namespace
