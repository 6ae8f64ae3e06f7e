/// Results of a lab's tests if some of them end the program that runs them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "cli/grading/crash_report.hpp"
#include "cli/grading/graded_run.hpp"
#include "cli/scratch_project.hpp"

namespace {

namespace fs = std::filesystem;
using cs550::cli::GradedTest;
using cs550::cli::run_graded_tests;
using cs550::cli::Verdict;
using Kind = cs550::cli::Verdict::Kind;

constexpr std::chrono::seconds patience{60};

using GradedRun = cs550::cli::ScratchProject;

TEST_F(GradedRun, GivesEveryTestItsVerdictInTheOrderOfTheTests) {
  // Two tests crash. The other tests of the same process still count.
  const std::vector<GradedTest> tests = {
      {"Crashes", "L5.3", 1, false}, {"Passes", "L5.1", 6, false},
      {"Fails", "L5.1", 5, false},   {"ReachesAnEarlierLab", "L5.2", 3, false},
      {"Throws", "L5.3", 2, true},   {"Leaves", "L5.3", 1, false},
      {"PassesToo", "L5.3", 1, true}};
  std::size_t arrived = 0;
  const std::vector<Verdict> verdicts =
      run_graded_tests(CS550_FAKE_LAB, 5, tests, patience,
                       [&](const std::vector<Verdict>& some) { arrived += some.size(); });
  EXPECT_EQ(arrived, tests.size());

  const std::vector<Kind> expected = {Kind::Failed, Kind::Passed, Kind::Failed, Kind::Blocked,
                                      Kind::Failed, Kind::Failed, Kind::Passed};
  ASSERT_EQ(verdicts.size(), tests.size());
  for (std::size_t i = 0; i < tests.size(); ++i) {
    EXPECT_EQ(verdicts[i].test.name, tests[i].name);
    EXPECT_EQ(verdicts[i].kind, expected[i]) << tests[i].name << ": " << verdicts[i].message;
  }
  EXPECT_EQ(verdicts[0].message,
            "crashed: Aborted\n"
            "try  ./cs550 lab 5 --asan  which prints the line\n"
            "in this case:\n"
            "A polygon is clipped\n"
            "  given     3 corners\n"
            "  likely    an empty polygon\n");
  EXPECT_EQ(verdicts[0].ending, "crashed: Aborted");
  EXPECT_EQ(verdicts[2].ending, "");
  EXPECT_EQ(verdicts[3].blocked_by, "L2.3");
  EXPECT_NE(verdicts[5].message.find("exit code 3"), std::string::npos);
  EXPECT_EQ(verdicts[1].earned(), 6);
  EXPECT_TRUE(fs::is_empty(root / "build/results")) << "drafts are left behind";
}

TEST_F(GradedRun, StopsAProgramThatComesToNoEnd) {
  const fs::path program = root / "endless";
  std::ofstream(program) << "#!/bin/sh\nwhile :; do :; done\n";
  fs::permissions(program, fs::perms::owner_all);
  const std::vector<Verdict> verdicts = run_graded_tests(
      program, 5, {{"Passes", "L5.1", 6, false}, {"Fails", "L5.1", 5, false}}, patience / 60);
  ASSERT_EQ(verdicts.size(), 2U);
  for (const Verdict& verdict : verdicts) {
    EXPECT_EQ(verdict.kind, Kind::Failed);
    EXPECT_NE(verdict.message.find("endless loop"), std::string::npos) << verdict.message;
  }
}

TEST_F(GradedRun, StopsAProgramThatPrintsWithoutEnd) {
  const fs::path program = root / "endless";
  std::ofstream(program) << "#!/bin/sh\nwhile :; do echo here; done\n";
  fs::permissions(program, fs::perms::owner_all);
  const std::vector<Verdict> verdicts = run_graded_tests(program, 5, {{"Passes", "L5.1", 6, false}},
                                                         patience, {}, {.output = 1 << 20});
  ASSERT_EQ(verdicts.size(), 1U);
  EXPECT_EQ(verdicts[0].kind, Kind::Failed);
  EXPECT_NE(verdicts[0].message.find("prints without end"), std::string::npos)
      << verdicts[0].message;
}

TEST_F(GradedRun, RemovesWhatAnInterruptedRunLeft) {
  const fs::path folder = root / "build/results";
  fs::create_directories(folder);
  const auto file_of = [&](int process, const std::string& ending) {
    return folder / ("lab5." + std::to_string(process) + ".0" + ending);
  };
  constexpr int nobody = 999999999;  // above the largest process id of Linux
  for (const char* ending : {".json", ".json.case", ".txt"}) {
    std::ofstream interrupted(file_of(nobody, ending));
  }
  std::ofstream under_way(file_of(getppid(), ".json"));
  std::ofstream results(folder / "lab5.json");
  run_graded_tests(CS550_FAKE_LAB, 5, {{"Passes", "L5.1", 6, false}}, patience);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2);
  EXPECT_TRUE(fs::exists(file_of(getppid(), ".json")));
  EXPECT_TRUE(fs::exists(folder / "lab5.json"));
}

TEST_F(GradedRun, TellsWhatTheSanitizersFound) {
  const std::vector<Verdict> verdicts = run_graded_tests(
      CS550_FAKE_SANITIZED_LAB, 5, {{"ReadsPastTheEnd", "L5.1", 1, false}}, patience);
  ASSERT_EQ(verdicts.size(), 1U);
  EXPECT_EQ(verdicts[0].kind, Kind::Failed);
  EXPECT_EQ(verdicts[0].message.rfind("memory error: heap-buffer-overflow", 0), 0U)
      << verdicts[0].message;
}

TEST_F(GradedRun, TellsWhereASanitizedProgramWasStopped) {
  cs550::cli::configure_sanitizers();
  const std::vector<Verdict> verdicts = run_graded_tests(
      CS550_FAKE_SANITIZED_LAB, 5, {{"NeverEnds", "L5.2", 1, false}}, patience / 60);
  ASSERT_EQ(verdicts.size(), 1U);
  EXPECT_EQ(verdicts[0].ending, "stopped: it did not end in time (an endless loop?)");
  EXPECT_NE(
      verdicts[0].message.find("\n  in the test, tests/autograder/fake_lab/fake_sanitized_lab"),
      std::string::npos)
      << verdicts[0].message;
}

TEST_F(GradedRun, NothingToRunGivesNoVerdicts) {
  EXPECT_TRUE(run_graded_tests(CS550_FAKE_LAB, 5, {}, patience).empty());
}

}  // namespace
