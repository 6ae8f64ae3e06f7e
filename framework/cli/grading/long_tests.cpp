#include "cli/grading/long_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace cs550::cli {

std::vector<GradedTest> only(const std::vector<GradedTest>& tests, bool is_long) {
  std::vector<GradedTest> chosen;
  std::copy_if(tests.begin(), tests.end(), std::back_inserter(chosen),
               [is_long](const GradedTest& test) { return test.is_long == is_long; });
  return chosen;
}

LongTests long_tests(const std::vector<GradedTest>& tests, const std::vector<Verdict>& short_tests,
                     bool everything) {
  LongTests result;
  for (const GradedTest& test : tests) {
    const auto failing =
        std::find_if(short_tests.begin(), short_tests.end(), [&test](const Verdict& verdict) {
          return verdict.kind == Verdict::Kind::Failed &&
                 !is_earlier_step(test.step, verdict.test.step);
        });
    if (everything || failing == short_tests.end()) {
      result.ready.push_back(test);
      continue;
    }
    const std::string& step = failing->test.step;
    result.waiting.push_back(
        {test, Verdict::Kind::Blocked,
         fmt::format("blocked by {}: a long test, which runs once {} passes (or with --all)", step,
                     step),
         0, step});
  }
  return result;
}

}  // namespace cs550::cli
