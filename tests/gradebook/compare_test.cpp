/// What changed between two runs.
#include <gtest/gtest.h>

#include "gradebook/command/compare.hpp"
#include "gradebook_test.hpp"

namespace cs550::gradebook {
namespace {

TEST(Compare, PrintsWhatChanged) {
  const std::vector<Record> before{record_of("ada", lab_record(24, 0, 0)),
                                   record_of("bob", lab_record(0, 0, 0)),
                                   record_of("eve", lab_record(0, 0, 0))};
  const std::vector<Record> after{record_of("ada", lab_record(24, 24, 0)),
                                  record_of("bob", lab_record(0, 0, 0))};
  EXPECT_EQ(comparison(before, after),
            "ada, lab 3: 24 of 60 -> 48 of 60\n"
            "    Lab3.ClimbEndsOnAPlateau: failed -> passed (+24 points)\n"
            "eve: removed\n"
            "1 of 2 submissions changed.\n");
}

TEST(Compare, NamesALabThatOnlyOneFolderHasOnce) {
  Record lab4 = record_of("ada", lab_record(24, 0, 0));
  lab4.labs[0].lab = 4;
  Record both = record_of("bob", lab_record(24, 0, 0));
  both.labs.push_back(lab4.labs[0]);
  EXPECT_EQ(comparison({record_of("ada", lab_record(24, 0, 0)), both}, {lab4, both}),
            "ada, lab 3: 24 of 60 -> no record\nada, lab 4: no record -> 24 of 60\n"
            "1 of 2 submissions changed.\n");
  EXPECT_EQ(comparison({record_of("ada", lab_record(24, 0, 0))}, {lab4}),
            "lab 3: only in the first folder, not compared\n"
            "lab 4: only in the second folder, not compared\n"
            "0 of 1 submissions changed.\n");
}

TEST(Compare, PrintsMilestonesThatChanged) {
  const Record ada = record_of("ada", lab_record(24, 0, 0));
  const Record before = with_engine(ada, {"passed", "failed", "not_submitted"});
  const Record after = with_engine(ada, {"failed", "passed", "passed"});
  EXPECT_EQ(comparison({before}, {after}),
            "ada, milestones: 1 of 3 reached -> 2 of 3 reached\n"
            "    Milestone.1: reached -> not reached\n"
            "    Milestone.2: not reached -> reached\n"
            "    Milestone.3: not submitted -> reached\n"
            "1 of 1 submissions changed.\n");
  EXPECT_EQ(comparison({before}, {before}), "0 of 1 submissions changed.\n");
  EXPECT_EQ(comparison({ada}, {after}),
            "ada, milestones: not run -> 2 of 3 reached\n1 of 1 submissions changed.\n");
}

TEST(Compare, PrintsABonusThatChanged) {
  const auto with_tests = [](const OwnTests& own) {
    Record record = record_of("ada", lab_record(24, 0, 0));
    record.labs[0].own_tests = own;
    return record;
  };
  const Record before = with_tests({true, 20, 20, false, "", ""});
  const auto changes = [&](const Record& after) { return comparison({before}, {after}); };
  const auto line = [](const std::string& after) {
    return "ada, lab 3: 24 of 60 -> 24 of 60\n    my_tests.cpp: 20 of 20 known mistakes -> " +
           after + "\n1 of 1 submissions changed.\n";
  };
  EXPECT_EQ(changes(with_tests({true, 21, 10, false, "", ""})), line("10 of 21 known mistakes"));
  EXPECT_EQ(changes(with_tests({true, 20, 0, true, "", ""})), line("fails on the reference"));
  EXPECT_EQ(changes(with_tests({false, 20, 0, false, "", ""})), line("does not compile"));
  EXPECT_EQ(changes(with_tests({true, 0, 0, false, "", "it broke"})), line("not graded"));
  EXPECT_EQ(changes(record_of("ada", lab_record(24, 0, 0))), line("not run"));
  EXPECT_EQ(changes(before), "0 of 1 submissions changed.\n");
}

}  // namespace
}  // namespace cs550::gradebook
