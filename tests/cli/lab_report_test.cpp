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

/// Of a test that ended the program: the first line says how.
Verdict ended(const std::string& test, const std::string& message) {
  Verdict result = verdict(test, "L3.1", Kind::Failed, message);
  result.ending = message.substr(0, message.find('\n'));
  return result;
}

std::string printed(const std::vector<Verdict>& verdicts, bool everything = false,
                    const std::vector<cs550::cli::KnownCause>& known = {},
                    const std::string& earlier_fault = "") {
  LabReport report(everything, known);
  testing::internal::CaptureStdout();
  report.print(verdicts);
  report.print_total(0, earlier_fault);
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
            "Fix L3.2 first. Other reports are left out; --all prints them.\n");
  EXPECT_NE(printed(verdicts, true).find("      wrong order\n"), std::string::npos);
}

TEST(LabReport, TheReportsOfOneStepAreShortenedButNotLeftOut) {
  const std::string check = "  given     a cube\n  expected  1 m/s\n  got       2 m/s\n";
  const Verdict whole = verdict("A", "L3.1", Kind::Failed, "up\n" + check);
  const Verdict short_one = verdict("B", "L3.1", Kind::Failed, "down\n" + check);
  const Verdict later = verdict("C", "L3.2", Kind::Failed, "wrong order");
  EXPECT_NE(printed({whole, short_one})
                .find("\nFix L3.1 first. Other reports are shortened; --all prints them.\n"),
            std::string::npos)
      << printed({whole, short_one});
  EXPECT_NE(
      printed({whole, short_one, later})
          .find("\nFix L3.1 first. Other reports are left out or shortened; --all prints them.\n"),
      std::string::npos)
      << printed({whole, short_one, later});
}

TEST(LabReport, ARepeatedReasonNamesTheTestThatHasIt) {
  const std::string report = printed({verdict("A", "L3.1", Kind::Failed, "not implemented"),
                                      verdict("B", "L3.1", Kind::Passed),
                                      verdict("C", "L3.1", Kind::Failed, "not implemented")});
  EXPECT_NE(report.find("C\n      the same as A\n"), std::string::npos) << report;
}

TEST(LabReport, TheCausesOfAStepArePrintedOnceWithItsFirstFailingTest) {
  const std::vector<Verdict> verdicts = {
      verdict("A", "L3.1", Kind::Failed, "up\n  likely    sign\n            order"),
      verdict("B", "L3.1", Kind::Failed,
              "down\n  likely    sign\n            scale\n            frame\n  picture   b.svg")};
  const std::string report = printed(verdicts, false, {{"scale", {"A", "B"}, {}}});
  EXPECT_NE(report.find("      up\n"
                        "        likely    scale\n"
                        "                  sign\n"
                        "                  order\n"),
            std::string::npos)
      << "the cause that explains both tests comes first, of the others there are a few\n"
      << report;
  EXPECT_NE(report.find("      down\n        picture   b.svg\n"), std::string::npos) << report;
  EXPECT_NE(printed(verdicts, true).find("frame\n"), std::string::npos);
}

TEST(LabReport, OnlyTheFirstFailingTestOfAStepIsReportedInFull) {
  const std::string check =
      "  given     seed = 1\n            size = 2 m\n  when      one pass\n  then      v\n"
      "  expected  1 m/s\n  got       2 m/s\n  also      w\n  +3 similar cases\n";
  const std::string crash = "crashed\n  given     a cube\ntry  ./cs550 lab 3 --asan";
  const std::vector<Verdict> verdicts = {verdict("A", "L3.1", Kind::Failed, "up\n" + check),
                                         verdict("B", "L3.1", Kind::Failed, "down\n" + check),
                                         verdict("C", "L3.1", Kind::Failed, crash)};
  const std::string report = printed(verdicts);
  EXPECT_NE(report.find("      up\n        given     seed = 1\n"), std::string::npos) << report;
  EXPECT_NE(report.find("        +3 similar cases\n"), std::string::npos) << report;
  EXPECT_NE(report.find("      down\n        then      v\n        expected  1 m/s\n"
                        "        got       2 m/s\n  FAILED"),
            std::string::npos)
      << report;
  EXPECT_NE(report.find("      crashed\n        given     a cube\n      try  ./cs550"),
            std::string::npos)
      << report;
  EXPECT_NE(printed(verdicts, true).find("      down\n        given     seed = 1\n"),
            std::string::npos);
}

TEST(LabReport, OnlyTheFirstCrashOfAStepIsReportedInFull) {
  const std::vector<Verdict> verdicts = {
      ended("A", "crashed\ntry  gdb\nin this case:\n  given     a cube\n"),
      ended("B", "crashed\ntry  gdb\nin this case:\n  given     a ball\n"),
      ended("C", "stopped\ntry  gdb\nafter this case, or in it:\n  given     a cone\n")};
  const std::string report = printed(verdicts);
  EXPECT_NE(report.find("a cube\n"), std::string::npos) << report;
  EXPECT_NE(report.find("B\n      crashed, like A\n  FAILED"), std::string::npos) << report;
  EXPECT_NE(report.find("a cone\n"), std::string::npos) << "it ended in another way\n" << report;
  EXPECT_NE(printed(verdicts, true).find("a ball\n"), std::string::npos);
}

TEST(LabReport, ACauseThatAPassingTestExcludesIsNotPrinted) {
  const std::vector<Verdict> verdicts = {
      verdict("A", "L3.1", Kind::Failed,
              "up\n  likely    the sign is wrong\n            the scale is wrong\n"
              "            the order is wrong\n  picture   a.svg"),
      verdict("B", "L3.1", Kind::Passed), verdict("C", "L3.2", Kind::Failed)};
  EXPECT_NE(printed(verdicts, false, {{"the sign", {"A", "B"}, {}}, {"the order", {"A"}, {"C"}}})
                .find("      up\n        likely    the order is wrong\n"
                      "                  the scale is wrong\n        picture   a.svg\n"),
            std::string::npos)
      << "the cause that explains most failures comes first";
  EXPECT_EQ(printed(verdicts, false,
                    {{"the sign", {"B"}, {}}, {"the scale", {"B"}, {}}, {"order", {"B"}, {}}})
                .find("likely"),
            std::string::npos)
      << "if none is left, the mistake is another one";
  EXPECT_NE(printed(verdicts, false, {{"the", {"B"}, {}}, {"the order", {"A"}, {}}})
                .find("the order is wrong\n"),
            std::string::npos)
      << "a cause that names two mistakes is left out if both are excluded";
}

TEST(LabReport, TestsOfOtherStepsDecideBetweenCausesThatExplainAsMuch) {
  const std::string two = "up\n  likely    sign\n            order\n";
  const std::vector<cs550::cli::KnownCause> known = {{"sign", {"A"}, {"B"}},
                                                     {"order", {"A"}, {"C"}}};
  const auto first_cause = [&](const Verdict& b, const Verdict& c) {
    const std::string report =
        printed({verdict("A", "L3.1", Kind::Failed, two), b, c}, false, known);
    return report.find("likely    sign") != std::string::npos ? "sign" : "order";
  };
  const Verdict b = verdict("B", "L3.2", Kind::Failed, "down");
  const Verdict c = verdict("C", "L3.3", Kind::Failed, "down");
  EXPECT_STREQ(first_cause(b, verdict("C", "L3.3", Kind::Passed)), "sign");
  EXPECT_STREQ(first_cause(verdict("B", "L3.2", Kind::Passed), c), "order");
  EXPECT_STREQ(first_cause(verdict("B", "L3.2", Kind::Failed, "not implemented: L3.2 f"), c),
               "order")
      << "an unwritten step is no mistake";
}

TEST(LabReport, ACauseOfEndlessLoopsComesFirstIfATestWasStopped) {
  const std::string causes = "in this case:\n  likely    sign\n            > and not >=\n";
  const std::vector<cs550::cli::KnownCause> known = {{"sign", {"A", "C"}, {}},
                                                     {">=", {"B"}, {}, {"A", "B"}}};
  const auto first_cause = [&](const std::string& ending) {
    const std::string report =
        printed({ended("A", ending + '\n' + causes), ended("B", ending + '\n' + causes),
                 verdict("C", "L3.1", Kind::Failed, "down")},
                false, known);
    return report.find("likely    sign") < report.find("likely    >") ? "sign" : ">=";
  };
  EXPECT_STREQ(first_cause("stopped: it did not end in time (an endless loop?)"), ">=");
  EXPECT_STREQ(first_cause("crashed: Segmentation fault"), "sign");
  const std::vector<Verdict> ends = {verdict("A", "L3.1", Kind::Failed, causes)};
  EXPECT_EQ(printed(ends, false, {{">=", {"A"}, {}, {"A"}}}).find(">="), std::string::npos)
      << "a test that ends excludes a cause for which it never does";
}

TEST(LabReport, ACrashHasNoCausesOfWrongValues) {
  for (const char* how : {"memory error: heap-buffer-overflow\n  in climb, labs/climb.cpp:7\n",
                          "crashed: Segmentation fault\ntry  ./cs550 lab 3 --asan\n"}) {
    const std::string report = printed(
        {ended("A", std::string(how) + "in this case:\n  given     a cube\n  likely    sign\n"),
         verdict("B", "L3.1", Kind::Failed, "up\n  likely    sign\n")});
    EXPECT_NE(report.find("a cube\n  FAILED    0/4  L3.1  B\n      up\n        likely    sign\n"),
              std::string::npos)
        << report;
  }
}

TEST(LabReport, AnEndlessLoopHasNoCausesOfWrongValues) {
  const Verdict stopped = ended(
      "A",
      "stopped: it did not end in time (an endless loop?)\nin this case:\n  given     a cube\n"
      "  likely    sign\n            order\n");
  for (const std::vector<cs550::cli::KnownCause>& known :
       {std::vector<cs550::cli::KnownCause>{},
        {{"sign", {"A", "B"}, {}}, {">=", {"A"}, {}, {"A"}}}}) {
    EXPECT_EQ(printed({stopped}, true, known).find("likely"), std::string::npos);
    const std::string report = printed(
        {stopped, verdict("B", "L3.1", Kind::Failed, "up\n  likely    sign\n")}, false, known);
    EXPECT_NE(report.find("a cube\n  FAILED    0/4  L3.1  B\n      up\n        likely    sign\n"),
              std::string::npos)
        << report;
  }
}

TEST(LabReport, ATestThatDidNotRunHasNoCauses) {
  const Verdict crashed = ended(
      "A", "crashed: Segmentation fault\nin this case:\n  given     a tower\n  likely    sign\n");
  Verdict waiting = verdict("B", "L3.1", Kind::Blocked, "blocked by L3.1: a long test");
  waiting.blocked_by = "L3.1";
  const std::string report = printed({crashed, waiting});
  EXPECT_NE(report.find("      blocked by L3.1: a long test\n\n"), std::string::npos) << report;
}

TEST(LabReport, AnEarlierLabThatDoesNotCompileComesAfterAStepThatFailsByItself) {
  Verdict blocked = verdict("A", "L4.2", Kind::Blocked, "blocked by lab 3, which does not compile");
  blocked.blocked_by = "L3.4";
  EXPECT_NE(printed({blocked}, false, {}, "lab 3").find("\nFix lab 3 first.\n"), std::string::npos);
  const Verdict failed = verdict("B", "L4.3", Kind::Failed, "wrong sign");
  const std::string report = printed({blocked, failed}, false, {}, "lab 3");
  EXPECT_NE(report.find("\nFix L4.3 first; lab 3 blocks 1 test.\n"), std::string::npos) << report;
}

TEST(LabReport, IfNothingFailsTheFirstLabThatBlocksATestIsNext) {
  const auto blocked_by = [](const std::string& step, const std::string& test) {
    Verdict blocked = verdict(test, "L5.1", Kind::Blocked, "blocked by " + step);
    blocked.blocked_by = step;
    return blocked;
  };
  const std::string report = printed({verdict("A", "L5.2", Kind::Passed), blocked_by("L4.3", "B"),
                                      blocked_by("L3.4", "C"), blocked_by("L3.1", "D")});
  EXPECT_NE(report.find("passed\nNext: write lab 3. 2 tests wait for it (8 points).\n"),
            std::string::npos)
      << report;
  EXPECT_NE(printed({blocked_by("L4.3", "A")}).find("Next: write lab 4. 1 test waits"),
            std::string::npos);
  for (const Verdict& other : {verdict("B", "L5.2", Kind::Failed, "wrong sign"),
                               blocked_by("L5.3", "B"), verdict("B", "L5.2", Kind::Passed)}) {
    EXPECT_EQ(printed({other}).find("Next"), std::string::npos) << printed({other});
  }
  EXPECT_EQ(printed({blocked_by("L4.3", "A"), verdict("B", "L5.2", Kind::Failed, "wrong sign")})
                .find("Next"),
            std::string::npos);
}

TEST(LabReport, AnEarlierLabThatFailsByItselfIsToBeFixedFirst) {
  const std::vector<Verdict> one = {verdict("A", "L4.1", Kind::Failed, "wrong sign")};
  EXPECT_NE(printed(one, false, {}, "lab 3").find("passed\nFix lab 3 first.\n"), std::string::npos);
  EXPECT_EQ(printed(one).find("Fix"), std::string::npos);
  const std::vector<Verdict> two = {one[0], verdict("B", "L4.2", Kind::Failed, "wrong order")};
  EXPECT_NE(printed(two, false, {}, "L3.1").find("\nFix L3.1 first. Other"), std::string::npos);
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
