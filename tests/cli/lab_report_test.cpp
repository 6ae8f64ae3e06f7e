/// The report that `./cs550 lab` prints.
#include "cli/grading/lab_report.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using cs550::cli::LabReport;
using cs550::cli::Verdict;
using Kind = cs550::cli::Verdict::Kind;

Verdict verdict(const std::string& test, const std::string& step, Kind kind,
                const std::string& message = "") {
  return {{test, step, 4, false}, kind, message, 0};
}

std::string printed(const std::vector<Verdict>& verdicts, bool everything = false,
                    const std::vector<cs550::cli::KnownCause>& known = {}) {
  LabReport report(everything, known);
  testing::internal::CaptureStdout();
  report.print(verdicts);
  report.print_total(0);
  return testing::internal::GetCapturedStdout();
}

TEST(LabReport, LaterStepsAreOneLineEachUntilTheFirstFailingStepPasses) {
  const std::vector<Verdict> verdicts = {verdict("A", "L3.1", Kind::Passed),
                                         verdict("B", "L3.2", Kind::Failed, "wrong sign"),
                                         verdict("C", "L3.10", Kind::Failed, "wrong order")};
  EXPECT_EQ(printed(verdicts),
            "  passed    4/4  L3.1  A\n"
            "  FAILED    0/4  L3.2  B\n"
            "      wrong sign\n"
            "  FAILED    0/4  L3.10 C\n"
            "\n4 of 12 points, 1 of 3 tests passed\n"
            "Fix L3.2 first. Reasons in later steps are left out; --all prints them.\n");
  EXPECT_NE(printed(verdicts, true).find("      wrong order\n"), std::string::npos);
}

TEST(LabReport, ARepeatedReasonNamesTheTestThatHasIt) {
  const std::string report = printed({verdict("A", "L3.1", Kind::Failed, "not implemented"),
                                      verdict("B", "L3.1", Kind::Passed),
                                      verdict("C", "L3.1", Kind::Failed, "not implemented")});
  EXPECT_NE(report.find("C\n      the same as A\n"), std::string::npos) << report;
}

TEST(LabReport, ACauseIsPrintedOnce) {
  const std::string report =
      printed({verdict("A", "L3.1", Kind::Failed, "up\n  likely    sign\n            order"),
               verdict("B", "L3.1", Kind::Failed,
                       "down\n  likely    sign\n            scale\n  picture   b.svg")});
  EXPECT_NE(report.find("      down\n        likely    scale\n        picture   b.svg\n"),
            std::string::npos)
      << report;
}

TEST(LabReport, ACauseThatAPassingTestExcludesIsNotPrinted) {
  const std::vector<Verdict> verdicts = {
      verdict("A", "L3.1", Kind::Failed,
              "up\n  likely    the sign is wrong\n            the scale is wrong\n"
              "            the order is wrong\n  picture   a.svg"),
      verdict("B", "L3.1", Kind::Passed), verdict("C", "L3.2", Kind::Failed)};
  EXPECT_NE(printed(verdicts, false, {{"the sign", {"A", "B"}}, {"the order", {"A", "C"}}})
                .find("      up\n        likely    the order is wrong\n"
                      "                  the scale is wrong\n        picture   a.svg\n"),
            std::string::npos)
      << "the cause that explains most failures comes first";
  EXPECT_NE(printed(verdicts, false, {{"the sign", {"B"}}, {"the scale", {"B"}}, {"order", {"B"}}})
                .find("the sign is wrong\n"),
            std::string::npos)
      << "if none is left, the mistake is another one: all are printed";
}

TEST(LabReport, ABlockedTestDoesNotHideTheReasonsOfLaterSteps) {
  Verdict blocked = verdict("A", "L3.2", Kind::Blocked, "blocked by L3.4: not implemented");
  blocked.blocked_by = "L3.4";
  const std::string report = printed({blocked, verdict("B", "L3.3", Kind::Failed, "wrong sign")});
  EXPECT_NE(report.find("  blocked   0/4  L3.2  A\n      blocked by L3.4"), std::string::npos)
      << report;
  EXPECT_NE(report.find("wrong sign"), std::string::npos) << report;
  EXPECT_EQ(blocked.step_to_mend(), "L3.4");
}

}  // namespace
