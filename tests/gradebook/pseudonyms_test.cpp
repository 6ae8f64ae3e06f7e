/// Reports without names: nobody can be recognised, and marks stay what they are.
#include <gtest/gtest.h>

#include "cli/system/files.hpp"
#include "gradebook/marks/mark.hpp"
#include "gradebook/marks/pseudonyms.hpp"
#include "gradebook/marks/time_text.hpp"
#include "gradebook/reports/write_reports.hpp"
#include "gradebook_test.hpp"

namespace cs550::gradebook {
namespace {

TEST(Pseudonyms, LeaveNoOrderAndNoTime) {
  constexpr long due = 1791842340;  // 2026-10-12T23:59:00+02:00
  const std::string late =
      "secret = 'x'\nattempt = 'last'\n[lab.3]\ndue = 2026-10-12T23:59:00+02:00\n"
      "[late]\npercent_per_day = 10\ngrace_minutes = 15\nclock = ";
  for (const char* clock : {"'file'", "'manifest'"}) {
    const Course course = course_of(late + clock);
    std::vector<Student> roster;
    std::vector<Record> records;
    for (int i = 0; i < 9; ++i) {
      roster.push_back({"s" + std::to_string(i), "", "", "", {}, true, {}});
      for (const int points : {24, 12}) {  // the second attempt is the last, and worse
        records.push_back(record_of(roster.back().id, lab_record(points, 0, 0)));
        records.back().file_time = due - 30000 + 20000 * i + points % 24;
        records.back().claimed_date =
            to_text(Time(std::chrono::seconds(*records.back().file_time)));
        records.back().starter = "a commit";
      }
    }
    const PseudonymousClass hidden = with_pseudonyms(records, roster, course);
    EXPECT_TRUE(std::is_sorted(hidden.roster.begin(), hidden.roster.end(),
                               [](const Student& a, const Student& b) { return a.id < b.id; }));
    std::set<std::string> times;
    for (const Record& record : hidden.records) {
      EXPECT_EQ(record.starter, "");
      times.insert(std::to_string(record.file_time.value_or(0)) + record.claimed_date);
    }
    EXPECT_EQ(times.size(), 6U) << "in time and 1 and 2 days late, two attempts each";
    std::map<std::string, double> marks;
    for (const StudentMark& mark : mark_class(assign(roster, records), {3}, course)) {
      marks[mark.student.id] = mark.percent;
    }
    for (const StudentMark& mark :
         mark_class(assign(hidden.roster, hidden.records), {3}, hidden.course)) {
      EXPECT_DOUBLE_EQ(mark.percent, marks.at(hidden.key.at(mark.student.id)));
    }
  }
}

TEST(Pseudonyms, KeepTheOrderOfAttempts) {
  const Course course = course_of(
      "secret = 'x'\nattempt = 'last'\n[lab.1]\ndue = 2026-10-05T23:59:00Z\n"
      "[lab.2]\ndue = 2026-10-08T23:59:00Z\n[late]\nclock = 'file'\npercent_per_day = 10\n"
      "[[extension]]\nstudent = 'ada'\nlab = 1\ndue = 2026-10-19T23:59:00Z\nreason = 'r'\n");
  const auto handed_in_on = [](const char* date, int first) {
    Record record = record_of("ada", lab_record(first, 0, 0));
    record.labs[0].lab = 1;
    record.file_time = parse_time(std::string(date) + "T12:00:00Z")->time_since_epoch().count();
    return record;
  };
  std::vector<Record> records{handed_in_on("2026-10-05", 24), handed_in_on("2026-10-07", 0)};
  records[1].labs.push_back(records[1].labs[0]);
  records[1].labs[1].lab = 2;
  const PseudonymousClass hidden = with_pseudonyms(records, {}, course);
  EXPECT_LT(hidden.records[0].file_time, hidden.records[1].file_time);
  const StudentMark mark = mark_class(assign({}, hidden.records), {1, 2}, hidden.course).front();
  EXPECT_DOUBLE_EQ(mark.labs[0].mark, 0) << "the last attempt counts";
}

TEST(Pseudonyms, LeaveAStudentWithoutAMarkWithoutOne) {
  Record best = record_of("ada", lab_record(24, 24, 12));
  Record failed = record_of("ada", lab_record(0, 0, 0));
  failed.labs[0].not_graded = "the judge broke";
  failed.labs[0].files = {"ada.cpp", "my_tests.cpp"};
  const std::vector<Record> records{best, failed};
  const Course course = course_of("secret = 'x'\n[lab.3]\nown_tests = 5\n");
  const PseudonymousClass hidden = with_pseudonyms(records, {}, course);
  EXPECT_EQ(hidden.records[1].labs[0].files, std::vector<std::string>{"my_tests.cpp"});
  EXPECT_FALSE(mark_class(assign({}, records), {3}, course)[0].is_graded());
  EXPECT_FALSE(mark_class(assign({}, hidden.records), {3}, hidden.course)[0].is_graded());
}

TEST(Pseudonyms, LeaveNoName) {
  Record record = hostile_record();
  record.student = record.source = record.claimed_student = "Lovelace";
  record.ignored = {{"Lovelace/notes.txt", "Lovelace", 1}};
  record.labs[0].files = {"lovelace.cpp"};
  record.folders = {"Lovelace"};
  record.labs[0].tests[0].message = "Lovelace was here";
  const Course course = course_of(
      "secret = 'x'\n[[adjustment]]\nstudent = 'Lovelace'\nlab = 3\npoints = 2\n"
      "reason = 'Lovelace explained it'\n");
  Record failed = record;
  failed.name = "failed";
  failed.trouble = "cannot read Lovelace/notes.txt";
  failed.labs[0].not_graded = "no room for lovelace.cpp";
  const std::vector<Record> records{record, failed};
  const PseudonymousClass hidden = with_pseudonyms(records, {}, course);
  const ScratchFolder scratch;
  write_reports(scratch / "out", hidden.records, hidden.roster, hidden.course);
  for (const auto& file : cli::files_below(scratch / "out")) {
    EXPECT_EQ(cli::read_text(file).find("ovelace"), std::string::npos) << file;
  }
  EXPECT_EQ(hidden.key.begin()->second, "Lovelace");
  const std::vector<StudentMark> marks = mark_class(assign({}, hidden.records), {3}, hidden.course);
  EXPECT_DOUBLE_EQ(marks[0].labs[0].mark, 26) << "adjustments follow the pseudonym";
  const Course other = course_of("secret = 'y'");
  EXPECT_NE(with_pseudonyms(records, {}, other).key.begin()->first, hidden.key.begin()->first);
}

}  // namespace
}  // namespace cs550::gradebook
