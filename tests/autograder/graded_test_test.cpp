/// The runner's verdict on each outcome of a test. The fake lab is a separate program, as a
/// student's lab is.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "helpers/scratch_folder.hpp"

namespace {

struct Outcome {
  int exit_code;
  std::string output;
};

Outcome run_fake_lab(const std::string& arguments) {
  const std::string command = "\"" + std::string(CS550_FAKE_LAB) + "\" " + arguments + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  std::string output;
  std::array<char, 4096> buffer;
  while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    output.append(buffer.data(), size);
  }
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output};
}

/// Runs one test and returns its row of the results file.
class GradedTestVerdict : public testing::Test {
 protected:
  nlohmann::json verdict(const std::string& test) {
    run = run_fake_lab("--gtest_filter=Lab5." + test + " --results " + file.string());
    results = nlohmann::json::parse(std::ifstream(file));
    return results["tests"].at(0);
  }

  void TearDown() override {
    std::filesystem::remove(file);
    std::filesystem::remove(file.string() + ".case");
  }

  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) /
      (std::string("verdict_") + testing::UnitTest::GetInstance()->current_test_info()->name() +
       ".json");
  Outcome run;
  nlohmann::json results;
};

TEST_F(GradedTestVerdict, PassingEarnsThePoints) {
  const nlohmann::json test = verdict("Passes");
  EXPECT_EQ(test["test"], "Lab5.Passes");
  EXPECT_EQ(test["status"], "passed");
  EXPECT_EQ(test["step"], "L5.1");
  EXPECT_EQ(test["points"], 6);
  EXPECT_EQ(test["earned"], 6);
  EXPECT_EQ(results["earned"], 6);
  EXPECT_EQ(run.exit_code, 0);
}

TEST_F(GradedTestVerdict, FailingEarnsNothing) {
  const nlohmann::json test = verdict("Fails");
  EXPECT_EQ(test["status"], "failed");
  EXPECT_EQ(test["earned"], 0);
  EXPECT_EQ(results["points"], 5);
  EXPECT_EQ(run.exit_code, 1);
}

TEST_F(GradedTestVerdict, UnwrittenStepSaysSoAndNothingElse) {
  const nlohmann::json test = verdict("ReachesAnUnwrittenStep");
  EXPECT_EQ(test["status"], "failed");
  const std::string message = test["message"];
  EXPECT_EQ(message.rfind("not implemented: L5.2 clip (tests/autograder/fake_lab/fake_lab.cpp:", 0),
            0U)
      << message;
  EXPECT_EQ(message.find("exception"), std::string::npos) << message;
  EXPECT_EQ(run.exit_code, 1);
}

TEST_F(GradedTestVerdict, UnfinishedEarlierLabBlocksRatherThanFails) {
  const nlohmann::json test = verdict("ReachesAnEarlierLab");
  EXPECT_EQ(test["status"], "blocked");
  EXPECT_EQ(test["blocked_by"], "L2.3");
  EXPECT_EQ(test["earned"], 0);
  const std::string message = test["message"];
  EXPECT_NE(message.find("blocked by lab 2: not implemented: L2.3 merge"), std::string::npos);
  EXPECT_EQ(run.exit_code, 77);
}

TEST_F(GradedTestVerdict, UnwrittenLaterStepOfTheLabBlocksToo) {
  const nlohmann::json test = verdict("ReachesALaterStep");
  EXPECT_EQ(test["status"], "blocked");
  EXPECT_EQ(test["blocked_by"], "L5.4");
  const std::string message = test["message"];
  EXPECT_EQ(message.rfind("blocked by L5.4: not implemented: L5.4 reduce", 0), 0U) << message;
}

TEST_F(GradedTestVerdict, ExceptionIsNamedWithItsStep) {
  EXPECT_EQ(verdict("Throws")["message"], "uncaught exception in L5.3: index 9 of 4");
  EXPECT_EQ(run.exit_code, 1);
}

TEST_F(GradedTestVerdict, EndlessAllocationIsNamed) {
  EXPECT_EQ(verdict("AllocatesTooMuch")["message"],
            "uncaught exception in L5.3: it allocated too much memory (a loop that adds elements "
            "without end?)");
}

TEST_F(GradedTestVerdict, ThrownNumberIsAFailureToo) {
  const nlohmann::json test = verdict("ThrowsANumber");
  EXPECT_EQ(test["status"], "failed");
  EXPECT_EQ(test["earned"], 0);
}

TEST_F(GradedTestVerdict, CrashLeavesTheTestThatRanLast) {
  const nlohmann::json test = verdict("Passes:Lab5.Crashes");
  EXPECT_EQ(test["status"], "passed");
  EXPECT_EQ(results["tests"].at(1)["test"], "Lab5.Crashes");
  EXPECT_EQ(results["tests"].at(1)["status"], "running");
  EXPECT_EQ(results["earned"], 6);
  EXPECT_NE(run.exit_code, 0);
}

TEST(GradedTestProgram, FilterThatMatchesNothingIsWrongUsage) {
  EXPECT_EQ(run_fake_lab("--gtest_filter=Lab5.Nothing").exit_code, 2);
}

TEST(GradedTestProgram, UnknownOptionIsWrongUsage) {
  EXPECT_EQ(run_fake_lab("--colour").exit_code, 2);
}

TEST(GradedTestProgram, PointsAndStepReachTheXmlReport) {
  const cs550::test::ScratchFolder folder;
  const std::filesystem::path file = folder / "fake_lab.xml";
  run_fake_lab("--gtest_filter=Lab5.Passes --gtest_output=xml:" + file.string());
  std::ifstream stream(file);
  const std::string report{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_NE(report.find("name=\"points\" value=\"6\""), std::string::npos) << report;
  EXPECT_NE(report.find("name=\"step\" value=\"L5.1\""), std::string::npos) << report;
}

TEST(GradedTestProgram, ManifestListsEveryTestInOrder) {
  const nlohmann::json manifest = nlohmann::json::parse(run_fake_lab("--manifest").output);
  EXPECT_EQ(manifest["lab"], 5);
  EXPECT_EQ(manifest["points"]["visible"], 27);
  ASSERT_EQ(manifest["tests"].size(), 11U);
  EXPECT_EQ(manifest["tests"].at(0)["name"], "Passes");
  EXPECT_EQ(manifest["tests"].at(0)["long"], false);
  EXPECT_EQ(manifest["tests"].at(5)["name"], "Throws");
  EXPECT_EQ(manifest["tests"].at(5)["long"], true);
}

}  // namespace
