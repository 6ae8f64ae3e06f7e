#include <cs550/graded_test.hpp>
#include <cs550/test_report.hpp>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "manifest.hpp"
#include "results.hpp"
#include "whose_code.hpp"

namespace {

using namespace cs550::autograder;

enum ExitCode { AllPassed = 0, SomeFailed = 1, BadUsage = 2, OnlyBlocked = 77 };

constexpr const char* usage = R"(Runs the graded tests of one lab.

  --results FILE    write the results as JSON, kept up to date while the tests run;
                    FILE.case describes the running test, and stays if the program crashes
  --manifest        print the list of tests with their points and steps as JSON
  --challenge       print the counts of the lab's challenges as JSON
  --whose           print for each lab function whose code it is
  --gtest_filter=Lab3.Name    run one test; other GoogleTest options: --gtest_help

Exit code: 0 all passed, 1 some failed, 2 wrong usage, 77 none failed, but some are blocked by an
unwritten step.
)";

struct Options {
  std::string results;
};

/// Answers the questions that need no test to run; empty when tests are to be run.
std::optional<int> answer(const std::vector<std::string>& arguments, Options& options) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument == "--help") {
      std::cout << usage;
      return AllPassed;
    }
    if (argument == "--manifest") {
      std::cout << manifest();
      return AllPassed;
    }
    if (argument == "--challenge") {
      std::cout << challenge_counts();
      return AllPassed;
    }
    if (argument == "--whose") {
      std::cout << whose_code_text();
      return AllPassed;
    }
    if (argument == "--results" && i + 1 < arguments.size()) {
      options.results = arguments[++i];
    } else if (argument.rfind("--gtest_", 0) != 0) {
      std::cerr << "unknown or incomplete option " << argument << "\n\n" << usage;
      return BadUsage;
    }
  }
  return std::nullopt;
}

/// In a students' copy the starter fills in for a function that a lab lacks, and for all of a file that
/// does not compile.
void announce_stubs() {
  std::map<int, std::string> missing;
  bool all_stubs = true;  // the program of the starter itself
  for (const LabFunction& function : lab_functions()) {
    const bool stub = whose(function) == "stub";
    all_stubs = all_stubs && stub;
    if (!stub) continue;
    std::string& names = missing[function.lab];
    const std::string name = readable_name(function);
    names += (names.empty() ? "" : ", ") + name.substr(0, name.find('('));
  }
  if (all_stubs) return;
  for (const auto& [lab, names] : missing) {
    std::cout << "note: lab " << lab << " does not define " << names
              << ", or its file does not compile; the starter is used instead\n";
  }
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (const auto code = answer(std::vector<std::string>(argv + 1, argv + argc), options)) {
    return *code;
  }
  testing::InitGoogleTest(&argc, argv);
  announce_stubs();

  std::optional<CaseFile> case_file;
  if (!options.results.empty()) case_file.emplace(options.results + ".case");
  auto* results = new ResultsWriter(options.results);  // owned by GoogleTest
  testing::UnitTest::GetInstance()->listeners().Append(results);
  const bool passed = RUN_ALL_TESTS() == 0;
  if (testing::GTEST_FLAG(list_tests)) {
    return AllPassed;
  }
  if (results->finished() == 0) {
    std::cerr << "no test matches\n";
    return BadUsage;
  }
  if (!passed || results->failed() > 0) {
    return SomeFailed;
  }
  return results->blocked() > 0 ? OnlyBlocked : AllPassed;
}
