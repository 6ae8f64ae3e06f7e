/// Records: as JSON, and those of several runs together.
#include <gtest/gtest.h>

#include "gradebook/records/merge.hpp"
#include "gradebook/records/record_json.hpp"
#include "gradebook_test.hpp"

namespace cs550::gradebook {
namespace {

TEST(Records, SurviveARoundTrip) {
  Record record = record_of("ada", lab_record(24, 0, 12));
  record.ignored = {{"framework/", "not in a lab's folder", 312}};
  record.labs[0].supplied = {"merging.cpp"};
  record.labs[0].seed = "abc";
  record.file_time = 1791842340;
  record.is_identified = true;
  record.folders = {"sectionA", "ada"};
  const std::string text = to_json(record);
  EXPECT_EQ(to_json(record_from_json(text, "ada.json")), text);
  EXPECT_THROW(record_from_json("{}", "ada.json"), std::runtime_error);
  EXPECT_THROW(record_from_json(text.substr(0, text.size() / 2), "ada.json"), std::runtime_error);
}

TEST(Merge, LabsOfOneSubmissionComeTogether) {
  const Record lab3 = record_of("ada", lab_record(24, 0, 0));
  Record lab4 = lab3;
  lab4.labs[0].lab = 4;
  Record other = lab3;
  other.hash = "other content";
  const std::vector<Record> records = merged({{lab3}, {lab4, other}, {lab3}});
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].labs.size(), 2U);
  EXPECT_EQ(records[1].name, "ada-2");
}

TEST(Merge, EqualFilesOfTwoStudentsStayTwoSubmissions) {
  Record ada = record_of("lab3", lab_record(24, 0, 0));
  ada.claimed_student = "ada";
  Record bob = ada;
  bob.claimed_student = "bob";
  EXPECT_EQ(merged({{ada}, {bob}}).size(), 2U) << "of two claims";
  Record again = ada;
  again.source = "lab3-again.zip";
  EXPECT_EQ(merged({{ada}, {again}}).size(), 2U) << "of two names";
  again = ada;
  again.folders = {"sectionA", "eve"};
  EXPECT_EQ(merged({{ada}, {again}}).size(), 2U) << "of two folders";
  EXPECT_EQ(merged({{ada}, {ada}}).size(), 1U);
}

TEST(Merge, EqualFilesOfTwoTimesStayTwoSubmissions) {
  const Record in_time = record_of("ada", lab_record(24, 0, 0));
  Record late = in_time;
  late.file_time = 1791842340;
  EXPECT_EQ(merged({{in_time}, {late}}).size(), 2U) << "of two times of the file";
  late = in_time;
  late.claimed_date = "2026-10-12T23:59:00+02:00";
  EXPECT_EQ(merged({{in_time}, {late}}).size(), 2U) << "of two dates of the manifest";
}

TEST(Merge, OwnTestsThatWereGradedCount) {
  const auto with_tests = [](const std::string& not_graded) {
    Record record = record_of("ada", lab_record(24, 0, 0));
    record.labs[0].own_tests = OwnTests{true, 20, 8, false, "", not_graded};
    return record;
  };
  const Record failed = with_tests("the judge broke");
  const Record graded = with_tests("");
  Record without_lab = failed;
  without_lab.labs[0].not_graded = "the judge broke";
  const auto lab_of = [](const Record& first, const Record& second) {
    return merged({{first}, {second}}).at(0).labs.at(0);
  };
  EXPECT_TRUE(lab_of(failed, graded).is_graded());
  EXPECT_TRUE(lab_of(graded, failed).is_graded());
  EXPECT_EQ(lab_of(failed, without_lab).not_graded, "") << "the mark of the lab stays";
  EXPECT_EQ(lab_of(without_lab, failed).not_graded, "");
  Record fewer_points = record_of("ada", lab_record(0, 0, 0));
  fewer_points.labs[0].own_tests = graded.labs[0].own_tests;
  EXPECT_EQ(lab_of(failed, fewer_points).own_tests->not_graded, "");
  EXPECT_EQ(lab_of(failed, fewer_points).earned(), 24) << "the points of the first stay";
  const Record without_tests = record_of("ada", lab_record(24, 0, 0));
  EXPECT_TRUE(lab_of(failed, without_tests).own_tests) << "the note on them stays";
}

TEST(Merge, MilestonesThatWereNotGradedStay) {
  const Record without = record_of("ada", lab_record(24, 0, 0));
  const Record failed = with_broken_engine(without, 2);
  const Record graded = with_engine(without, {"passed", "failed"});
  const auto engine_of = [](const Record& first, const Record& second) {
    return merged({{first}, {second}}).at(0).engine;
  };
  ASSERT_TRUE(engine_of(failed, without)) << "no milestones replace those that were not graded";
  EXPECT_EQ(engine_of(failed, without)->not_graded, "the judge broke");
  EXPECT_EQ(engine_of(without, failed)->not_graded, "the judge broke");
  for (const Record& other : {without, failed}) {
    EXPECT_EQ(engine_of(other, graded)->not_graded, "");
    EXPECT_EQ(engine_of(graded, other)->not_graded, "");
  }
  const Record fewer = with_engine(without, {"failed"});
  for (const auto& [first, second] : {std::pair(fewer, graded), std::pair(graded, fewer)}) {
    const std::vector<TestResult> milestones = engine_of(first, second)->tests;
    ASSERT_EQ(milestones.size(), 2U);
    EXPECT_EQ(milestones[0].status, first.engine->tests[0].status);
    EXPECT_EQ(milestones[1].name, "Milestone.2");
  }
}

}  // namespace
}  // namespace cs550::gradebook
