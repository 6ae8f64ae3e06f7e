/// The report of a test with several failed checks.
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <cs550/test_report.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace {

namespace fs = std::filesystem;
using namespace cs550::autograder;

FailedCheck wrong_vertex(const std::string& mesh, std::vector<std::string> causes = {}) {
  return {{"The climb ends on top", {mesh}, {"hill_climb()"}, std::move(causes)},
          "vertex",
          "7",
          "4",
          ""};
}

TEST(TestReport, ShowsTheSimplestCaseAndCountsTheSimilarOnes) {
  EXPECT_EQ(summary({wrong_vertex("mesh random_hull_32"), wrong_vertex("mesh cube"),
                     wrong_vertex("mesh prism32")}),
            "The climb ends on top\n"
            "  given     mesh cube\n"
            "  when      hill_climb()\n"
            "  then      vertex\n"
            "  expected  7\n"
            "  got       4\n"
            "  +2 similar cases\n");
}

TEST(TestReport, PrefersACaseThatIsNotRandom) {
  FailedCheck random = wrong_vertex("box");
  random.at.is_random = true;
  EXPECT_NE(summary({random, wrong_vertex("mesh prism32")}).find("prism32"), std::string::npos);
}

TEST(TestReport, NamesEachCauseOnceAndTheOneOfMostCasesFirst) {
  const std::string text = summary(
      {wrong_vertex("mesh cube", {"sign", "order"}), wrong_vertex("mesh prism", {"order"})});
  EXPECT_NE(text.find("  likely    order\n            sign\n"), std::string::npos) << text;
}

TEST(TestReport, NamesFurtherChecksOfTheCaseAndOtherProperties) {
  FailedCheck path = wrong_vertex("mesh cube");
  path.what = "length of the path";
  FailedCheck other = wrong_vertex("mesh cube in the dark");
  other.at.property = "The climb starts where it is told";
  const std::string text = summary({wrong_vertex("mesh cube"), path, other});
  EXPECT_NE(text.find("  also      length of the path\n"
                      "  also      The climb starts where it is told\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("similar"), std::string::npos) << text;
}

TEST(TestReport, KeepsTheChecksOfTheRunningTestApartFromOtherFailures) {
  EXPECT_TRUE(failed_checks().empty());
  EXPECT_NONFATAL_FAILURE(report_failure(wrong_vertex("mesh cube"), __FILE__, __LINE__), "got");
  ASSERT_EQ(failed_checks().size(), 1U);
  EXPECT_FALSE(is_simplest_so_far(wrong_vertex("mesh prism").at));
  EXPECT_TRUE(is_simplest_so_far(wrong_vertex("hull").at));
  EXPECT_TRUE(other_failures().empty());
}

TEST(TestReport, TheCaseIsInItsFileAtOnceAndUntilTheEnd) {
  const fs::path file = fs::path(testing::TempDir()) / ("case_" + std::to_string(getpid()));
  const auto text_in_file = [&] {
    std::ifstream stream(file);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    return text.substr(0, text.find('\0'));
  };
  {
    const CaseFile case_file(file);
    note_case(wrong_vertex("mesh cube", {"order"}).at);
    const std::string about =
        "The climb ends on top\n  given     mesh cube\n  when      hill_climb()\n"
        "  likely    order\n";
    EXPECT_EQ(text_in_file(), "in this case:\n" + about);
    note_passed_check();
    EXPECT_EQ(text_in_file(), "after this case, or in it:\n" + about);
    note_passed_check();
    EXPECT_EQ(text_in_file(), "after this case, or in it:\n" + about);
    note_case({"long", {std::string(100000, 'x')}, {}, {}});
    EXPECT_EQ(text_in_file(), noted_case());
  }
  EXPECT_FALSE(fs::exists(file));
  EXPECT_EQ(noted_case(), "");
}

}  // namespace
