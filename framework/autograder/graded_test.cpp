#include <cs550/graded_test.hpp>
#include <cs550/not_implemented.hpp>
#include <cs550/test_report.hpp>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <tuple>

namespace cs550::autograder {
namespace {

std::vector<GradedTestInfo>& registry() {
  static std::vector<GradedTestInfo> tests;
  return tests;
}

/// A test whose own step is unwritten has failed. One that needs another step is blocked by it.
void report_unfinished(const GradedTestInfo& test, const NotImplemented& unfinished) {
  if (unfinished.step() != test.step) {
    testing::Test::RecordProperty("blocked_by", unfinished.step());
    const bool is_own_lab = unfinished.lab() == test.lab();
    GTEST_SKIP() << "blocked by "
                 << (is_own_lab ? unfinished.step() : "lab " + std::to_string(unfinished.lab()))
                 << ": " << unfinished.what();
  }
  ADD_FAILURE_AT(test.file.c_str(), test.line) << unfinished.what();
}

void report_exception(const GradedTestInfo& test, const std::string& what) {
  ADD_FAILURE_AT(test.file.c_str(), test.line)
      << "uncaught exception in " << test.step << ": " << what << '\n'
      << noted_case();
}

}  // namespace

std::vector<GradedTestInfo> graded_tests() {
  std::vector<GradedTestInfo> tests = registry();
  std::sort(tests.begin(), tests.end(), [](const GradedTestInfo& a, const GradedTestInfo& b) {
    return std::tuple(a.hidden(), a.file, a.line) < std::tuple(b.hidden(), b.file, b.line);
  });
  return tests;
}

void remember_graded_test(const GradedTestInfo& info) {
  for (const GradedTestInfo& other : registry()) {
    if (other.full_name() == info.full_name()) {
      std::cerr << info.file << ':' << info.line << ": " << info.full_name()
                << " exists already, see " << other.file << ':' << other.line << '\n';
      std::exit(2);
    }
  }
  registry().push_back(info);
}

void GradedTest::TestBody() {
  RecordProperty("points", info_.points);
  RecordProperty("step", info_.step);
  try {
    run();
  } catch (const NotImplemented& unfinished) {
    report_unfinished(info_, unfinished);
  } catch (const testing::AssertionException&) {
    // The expectation that ended the test has been reported.
  } catch (const std::bad_alloc&) {
    report_exception(info_,
                     "it allocated too much memory (a loop that adds elements without end?)");
  } catch (const std::exception& error) {
    report_exception(info_, error.what());
  } catch (...) {
    report_exception(info_, "its type is not derived from std::exception");
  }
}

}  // namespace cs550::autograder
