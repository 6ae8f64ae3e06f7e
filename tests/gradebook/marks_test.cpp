/// From records to marks: scale, lateness, extensions, adjustments, regrades, weights, milestones.
#include <gtest/gtest.h>

#include "gradebook/course/course_file.hpp"
#include "gradebook/marks/mark.hpp"
#include "gradebook/marks/time_text.hpp"
#include "gradebook/records/record_json.hpp"
#include "gradebook/reports/grades_csv.hpp"
#include "gradebook_test.hpp"

namespace cs550::gradebook {
namespace {

constexpr long day = 86400;
constexpr long due = 1791842340;  // 2026-10-12T23:59:00+02:00

LabMark mark_of(const Record& record, const std::string& course) {
  const Student student{"ada", "", "", "", {}, true, {&record}};
  return mark_student(student, {3}, course_of(course)).labs.at(0);
}

constexpr const char* late_course =
    "[lab.3]\ndue = 2026-10-12T23:59:00+02:00\npoints = 120\n"
    "[late]\nclock = 'file'\npercent_per_day = 10\ngrace_minutes = 15\nmost_percent = 50\n";

Record handed_in(long seconds_after_due) {
  Record record = record_of("ada", lab_record(24, 0, 12));
  record.file_time = due + seconds_after_due;
  return record;
}

TEST(Marks, PointsAreScaled) {
  const Record record = record_of("ada", lab_record(24, 0, 12));
  EXPECT_DOUBLE_EQ(mark_of(record, "").mark, 36);
  EXPECT_DOUBLE_EQ(mark_of(record, "[lab.3]\npoints = 100").mark, 60);
}

TEST(Marks, LateDaysAreDeductedAfterTheGracePeriod) {
  EXPECT_EQ(to_text(Time(std::chrono::seconds(due))), "2026-10-12T21:59:00Z");
  EXPECT_DOUBLE_EQ(mark_of(handed_in(-5), late_course).mark, 72);
  EXPECT_DOUBLE_EQ(mark_of(handed_in(15 * 60), late_course).mark, 72) << "within the grace period";
  EXPECT_DOUBLE_EQ(mark_of(handed_in(15 * 60 + 1), late_course).mark, 64.8) << "the first day";
  EXPECT_DOUBLE_EQ(mark_of(handed_in(day), late_course).mark, 64.8);
  EXPECT_DOUBLE_EQ(mark_of(handed_in(day + 1), late_course).mark, 57.6) << "the second day";
  EXPECT_DOUBLE_EQ(mark_of(handed_in(40 * day), late_course).mark, 36) << "the cap";
}

TEST(Marks, AnExtensionMovesTheDueDateOfOneStudent) {
  const std::string course = std::string(late_course) +
                             "[[extension]]\nstudent = 'ada'\nlab = 3\n"
                             "due = 2026-10-14T23:59:00+02:00\n";
  EXPECT_DOUBLE_EQ(mark_of(handed_in(2 * day), course).mark, 72);
  EXPECT_DOUBLE_EQ(mark_of(handed_in(3 * day), course).mark, 64.8);
  EXPECT_EQ(mark_of(handed_in(2 * day), course).notes.at(1),
            "extension until 2026-10-14T23:59:00+02:00")
      << "in the time zone in which it was granted";
  Record bob = handed_in(2 * day);
  const Student student{"bob", "", "", "", {}, true, {&bob}};
  EXPECT_DOUBLE_EQ(mark_student(student, {3}, course_of(course)).labs[0].mark, 57.6);
}

TEST(Marks, TheClockIsTheOneThatTheCourseNames) {
  Record record = handed_in(40 * day);
  record.claimed_date = "2026-10-12T20:00:00Z";
  std::string course = late_course;
  course.replace(course.find("'file'"), 6, "'manifest'");
  EXPECT_DOUBLE_EQ(mark_of(record, course).mark, 72);
  record.claimed_date = "yesterday";
  const LabMark unknown = mark_of(record, course);
  EXPECT_DOUBLE_EQ(unknown.mark, 72);
  EXPECT_NE(unknown.notes.back().find("unknown"), std::string::npos);
}

TEST(Marks, ALabWithPointsOfItsOwnSaysHowTheTestsCount) {
  const Record record = record_of("ada", lab_record(24, 0, 12));
  const LabMark mark = mark_of(record, "[lab.3]\npoints = 100\n");
  EXPECT_DOUBLE_EQ(mark.mark, 60);
  ASSERT_EQ(mark.notes.size(), 1U);
  EXPECT_EQ(mark.notes[0], "the tests give 36 of 60 points, which count as 60 of 100");
  EXPECT_TRUE(mark_of(record, "").notes.empty()) << "60 points are the tests' own";
}

TEST(Marks, ALabThatNoRunGradedForAStudentSaysSo) {
  const Record record = record_of("ada", lab_record(24, 0, 12));
  const Student student{"ada", "", "", "", {}, true, {&record}};
  const StudentMark mark = mark_student(student, {3, 6}, course_of(""));
  EXPECT_EQ(mark.labs[1].notes, std::vector<std::string>{note_not_run});
  const std::string text = grades_csv({mark}, {3, 6});
  EXPECT_NE(text.find("lab 6: " + std::string(note_not_run)), std::string::npos) << text;

  Record asked = record;
  asked.labs.push_back(LabRecord{});
  asked.labs[1].lab = 6;
  const Student other{"ada", "", "", "", {}, true, {&asked}};
  EXPECT_EQ(mark_student(other, {3, 6}, course_of("")).labs[1].notes,
            std::vector<std::string>{note_not_submitted});
}

TEST(Marks, ALabThatTheGraderFailedToGradeDoesNotBlameTheCompiler) {
  Record record = record_of("ada", lab_record(0, 0, 0));
  record.labs[0].compiled = false;
  record.labs[0].not_graded = "cannot read /secret/result.json";
  const Student student{"ada", "", "", "", {}, true, {&record}};
  const std::string text = grades_csv({mark_student(student, {3}, course_of(""))}, {3});
  EXPECT_EQ(text.find("does not compile"), std::string::npos) << text;
  EXPECT_NE(text.find("cannot read /secret"), std::string::npos) << "the instructor learns why";
}

TEST(Marks, ARegradeOfATestThatPassedHasNoEffect) {
  const Record record = record_of("ada", lab_record(24, 0, 12));
  const LabMark mark = mark_of(record,
                               "[[regrade]]\nstudent = 'ada'\nlab = 3\nstatus = 'granted'\n"
                               "test = 'Lab3.FirstOfEqualVerticesWins'\nnote = 'n'\n");
  EXPECT_DOUBLE_EQ(mark.mark, 36);
  EXPECT_NE(mark.notes.back().find("no effect"), std::string::npos) << mark.notes.back();
}

TEST(Marks, ASubmissionOfUnknownTimeIsNotLate) {
  Record record = handed_in(40 * day);
  record.file_time.reset();
  const LabMark mark = mark_of(record, late_course);
  EXPECT_DOUBLE_EQ(mark.mark, 72);
  EXPECT_EQ(mark.late_days, 0);
  EXPECT_NE(mark.notes.back().find("unknown"), std::string::npos);
  EXPECT_FALSE(record_from_json(to_json(record), "ada.json").file_time);
}

TEST(Marks, NothingIsEarnedAfterTheSolutionWasReleased) {
  const std::string course =
      std::string("[lab.3]\nsolution_released = 2026-10-12T23:59:00+02:00\n") +
      "[late]\nclock = 'file'\npercent_per_day = 0\n";
  EXPECT_DOUBLE_EQ(mark_of(handed_in(0), course).mark, 36);
  EXPECT_DOUBLE_EQ(mark_of(handed_in(1), course).mark, 0);

  const Course weighted = course_of(course + "[milestones]\nweight = 1\n");
  const auto engine_of = [&](std::vector<const Record*> records) {
    return mark_student({"ada", "", "", "", {}, true, std::move(records)}, {3}, weighted).engine;
  };
  const Record in_time = with_engine(handed_in(0), {"passed", "failed", "passed", "failed"});
  const Record too_late = with_engine(handed_in(1), {"passed", "failed", "passed", "passed"});
  EXPECT_EQ(engine_of({&in_time}).reached, 2);
  EXPECT_EQ(engine_of({&too_late}).reached, 2) << "milestones of labs 1 and 4, not of lab 3";
  EXPECT_EQ(engine_of({&too_late}).too_late, 1);
  const std::vector<Record> records{too_late};
  const std::string text = grades_csv(mark_class(assign({}, records), {3}, weighted), {3});
  EXPECT_NE(text.find("1 milestone reached after the solution was released"), std::string::npos)
      << text;
  EXPECT_EQ(engine_of({&in_time, &too_late}).reached, 3) << "the first one reached it in time";
  EXPECT_EQ(engine_of({&in_time, &too_late}).too_late, 0);
}

TEST(Marks, AdjustmentsAndRegradesComeFromTheCourseFile) {
  const Record record = record_of("ada", lab_record(0, 24, 12));
  const std::string regrade =
      "[[regrade]]\nstudent = 'ada'\nlab = 3\ntest = 'Lab3.FirstOfEqualVerticesWins'\nstatus = ";
  EXPECT_DOUBLE_EQ(mark_of(record, regrade + "'granted'").mark, 60);
  EXPECT_DOUBLE_EQ(mark_of(record, regrade + "'declined'").mark, 36);
  EXPECT_DOUBLE_EQ(mark_of(record, regrade + "'open'").mark, 36);
  const std::string adjustment =
      "[[adjustment]]\nstudent = 'ada'\nlab = 3\nreason = 'x'\npoints = ";
  EXPECT_DOUBLE_EQ(mark_of(record, adjustment + "2.5").mark, 38.5);
  EXPECT_DOUBLE_EQ(mark_of(record, adjustment + "-100").mark, 0) << "never negative";
}

TEST(Marks, EntriesNameAStudentByIdOrAddress) {
  const Record record = record_of("ada", lab_record(0, 24, 12));
  const Student student{"S0101", "", "ada@example.org", "", {}, true, {&record}};
  const auto points = [&](const std::string& name) {
    const Course course =
        course_of("[[adjustment]]\nstudent = '" + name + "'\nlab = 3\nreason = 'x'\npoints = 2\n");
    return mark_student(student, {3}, course).labs.at(0).mark;
  };
  EXPECT_DOUBLE_EQ(points("s0101"), 38);
  EXPECT_DOUBLE_EQ(points("Ada@Example.org"), 38);
  EXPECT_DOUBLE_EQ(points("s010"), 36);
  EXPECT_DOUBLE_EQ(points(""), 36);
}

TEST(Marks, ATestIsGrantedOnce) {
  const Record record = record_of("ada", lab_record(0, 24, 12));
  const std::string granted =
      "[[regrade]]\nstudent = 'ada'\nlab = 3\ntest = 'Lab3.FirstOfEqualVerticesWins'\n"
      "status = 'granted'\n";
  EXPECT_DOUBLE_EQ(mark_of(record, granted + granted).mark, 60);
}

TEST(Marks, EntriesAboutNobodyAreListed) {
  const Course course = course_of(
      "[[extension]]\nstudent = 's9'\nlab = 3\ndue = 2026-10-14T23:59:00+02:00\n"
      "[[adjustment]]\nstudent = 'ADA'\nlab = 3\nreason = 'x'\npoints = 2\n");
  const std::vector<Student> students{{"ada", "", "", "", {}, true, {}}};
  EXPECT_EQ(entries_about_nobody(course, students),
            std::vector<std::string>{"[[extension]] of lab 3 for s9"});
}

TEST(Marks, WeightsMakeTheTotal) {
  LabRecord lab4 = lab_record(0, 0, 0);
  lab4.lab = 4;
  Record record = record_of("ada", lab_record(24, 24, 12));
  record.labs.push_back(lab4);
  const Student student{"ada", "", "", "", {}, true, {&record}};
  EXPECT_DOUBLE_EQ(mark_student(student, {3, 4}, course_of("")).percent, 50);
  EXPECT_DOUBLE_EQ(mark_student(student, {3, 4}, course_of("[lab.3]\nweight = 3")).percent, 75);
}

TEST(Marks, TheBestOrTheLastAttemptCounts) {
  Record early = record_of("ada", lab_record(24, 24, 0));
  Record later = record_of("ada", lab_record(24, 0, 0));
  early.file_time = 1;
  later.file_time = 2;
  const Student student{"ada", "", "", "", {}, true, {&later, &early}};
  EXPECT_DOUBLE_EQ(mark_student(student, {3}, course_of("")).labs[0].mark, 48);
  EXPECT_DOUBLE_EQ(mark_student(student, {3}, course_of("attempt = 'last'")).labs[0].mark, 24);
}

TEST(Marks, OfAttemptsWhoseOrderIsUnknownTheBestCounts) {
  Record zip = record_of("ada", lab_record(24, 0, 0));
  Record folder = record_of("ada", lab_record(24, 24, 0));
  zip.file_time = 2;
  const Student student{"ada", "", "", "", {}, true, {&zip, &folder}};
  const Course course = course_of("attempt = 'last'");
  LabMark mark = mark_student(student, {3}, course).labs[0];
  EXPECT_DOUBLE_EQ(mark.mark, 48) << "a folder has no time";
  ASSERT_FALSE(mark.notes.empty());
  EXPECT_NE(mark.notes.back().find("which attempt is the last is unknown"), std::string::npos);
  folder.file_time = 2;
  EXPECT_DOUBLE_EQ(mark_student(student, {3}, course).labs[0].mark, 48) << "equal times";
  folder.file_time = 1;
  mark = mark_student(student, {3}, course).labs[0];
  EXPECT_DOUBLE_EQ(mark.mark, 24);
  EXPECT_TRUE(mark.notes.empty());
}

TEST(Marks, AnAttemptThatWasNotGradedIsNotHiddenByAWorseOne) {
  const Record graded = record_of("ada", lab_record(24, 0, 0));
  Record failed = record_of("ada", lab_record(0, 0, 0));
  failed.source = "ada-again.zip";
  failed.labs[0].not_graded = "the judge broke";
  const Student student{"ada", "", "", "", {}, true, {&graded, &failed}};
  const LabMark mark = mark_student(student, {3}, course_of("")).labs[0];
  EXPECT_FALSE(mark.is_graded);
  EXPECT_EQ(mark.notes, std::vector<std::string>{"NOT GRADED: the grader failed on ada-again.zip"});
  Record perfect = record_of("ada", lab_record(24, 24, 12));
  const Student other{"ada", "", "", "", {}, true, {&perfect, &failed}};
  EXPECT_TRUE(mark_student(other, {3}, course_of("")).labs[0].is_graded) << "nothing to gain";

  const Course bonus = course_of("[lab.3]\nown_tests = 30\n");
  Record with_bonus = record_of("ada", lab_record(24, 12, 0));
  OwnTests own;
  own.compiled = true;
  own.mistakes = own.caught = 20;
  with_bonus.labs[0].own_tests = own;
  const Student eager{"ada", "", "", "", {}, true, {&with_bonus, &failed}};
  EXPECT_FALSE(mark_student(eager, {3}, bonus).labs[0].is_graded) << "36 points and 30 for tests";
  perfect.labs[0].own_tests = own;
  EXPECT_TRUE(mark_student(other, {3}, bonus).labs[0].is_graded) << "nothing to gain";
  perfect.labs[0].own_tests->caught = 10;
  EXPECT_TRUE(mark_student(other, {3}, bonus).labs[0].is_graded) << "the other one has no tests";
  failed.labs[0].files = {"my_tests.cpp"};
  EXPECT_FALSE(mark_student(other, {3}, bonus).labs[0].is_graded) << "half of the bonus";
}

TEST(Marks, MilestonesThatWereNotGradedAreNoMark) {
  Record record = record_of("ada", lab_record(24, 24, 12));
  EXPECT_TRUE(record.is_graded());
  record.engine = LabRecord{};
  EXPECT_TRUE(record.is_graded());
  record.engine->not_graded = "the judge broke";
  EXPECT_FALSE(record.is_graded());
}

TEST(Marks, MilestonesThatWereNotGradedAreNotHiddenByWorseOnes) {
  const Course course = course_of("[milestones]\nweight = 1\n");
  const Record ada = record_of("ada", lab_record(24, 24, 12));
  const Record failed = with_broken_engine(ada, 2);
  const auto is_graded = [&](const Record& other) {
    return mark_student({"ada", "", "", "", {}, true, {&other, &failed}}, {3}, course).is_graded();
  };
  EXPECT_FALSE(is_graded(with_engine(ada, {"passed", "failed"})));
  EXPECT_TRUE(is_graded(with_engine(ada, {"passed", "passed"}))) << "nothing to gain";
}

TEST(Marks, AStudentWithoutMilestonesIsNoted) {
  const Record ada = with_engine(record_of("ada", lab_record(24, 24, 12)), {"passed", "passed"});
  const Record bob = record_of("bob", lab_record(24, 24, 12));
  const std::vector<Record> records{ada, bob};
  const std::string weighted = "[milestones]\nweight = 1\n";
  const auto notes = [&](const std::string& course) {
    return grades_csv(mark_class(assign({}, records), {3}, course_of(course)), {3});
  };
  const std::string text = notes(weighted);
  EXPECT_NE(text.find("\nada,,,,graded,100.00,60,2,\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\nbob,,,,graded,50.00,60,,"), std::string::npos) << text;
  EXPECT_NE(text.find(note_no_milestones), std::string::npos) << text;
  EXPECT_EQ(notes("").find(note_no_milestones), std::string::npos) << "they have no weight";

  const Course by_hand = course_of(
      weighted + "[[adjustment]]\nstudent = 'max'\nlab = 3\npoints = 30\nreason = 'oral'\n");
  const std::vector<Student> roster = parse_roster("id\nada\nbob\nmax\nzoe\n", "roster.csv");
  const std::vector<StudentMark> marks = mark_class(assign(roster, records), {3}, by_hand);
  EXPECT_DOUBLE_EQ(marks[2].percent, 25) << "max has 30 of 60 points, and no milestones";
  EXPECT_FALSE(marks[2].engine.was_run);
  EXPECT_TRUE(marks[3].engine.was_run) << "zoe is missing";
}

TEST(Marks, MilestonesThatNoRunHasRunForAStudentCountAsNotReached) {
  const Record ada = with_engine(record_of("ada", lab_record(24, 24, 12)), {"passed"});
  const Record bob = with_engine(record_of("bob", lab_record(24, 24, 12)), {"passed", "failed"});
  const std::vector<Record> records{ada, bob};
  const Course course = course_of("[milestones]\nweight = 1\n");
  const std::vector<StudentMark> marks = mark_class(assign({}, records), {3}, course);
  for (const StudentMark& mark : marks) {
    EXPECT_EQ(mark.engine.reached, 1);
    EXPECT_EQ(mark.engine.of, 2);
    EXPECT_DOUBLE_EQ(mark.percent, 75);
  }
  const std::string text = grades_csv(marks, {3});
  EXPECT_NE(text.find("\nada,,,,graded,75.00,60,1,1 milestone counts as not reached"), text.npos)
      << text;
  EXPECT_NE(text.find("\nbob,,,,graded,75.00,60,1,\n"), text.npos) << text;

  const std::vector<Record> failed{with_broken_engine(ada, 2), ada, bob};
  EXPECT_FALSE(mark_class(assign({}, failed), {3}, course)[0].is_graded())
      << "the engine that was not graded might have reached the other milestone";
}

TEST(Times, AreParsedWithTheirOffset) {
  EXPECT_EQ(to_text(*parse_time("2026-10-12T23:59:00+02:00")), "2026-10-12T21:59:00Z");
  EXPECT_EQ(to_text(*parse_time("2018-07-01T14:22:32.365935-07:00")), "2018-07-01T21:22:32Z");
  EXPECT_EQ(to_text(*parse_time("2026-10-12 23:59Z")), "2026-10-12T23:59:00Z");
  EXPECT_EQ(to_text(*parse_time("2026-10-12T23:59:00Z"), std::chrono::minutes(-210)),
            "2026-10-12T20:29:00-03:30");
  EXPECT_FALSE(parse_time("2026-10-12T23:59:00"));
  EXPECT_FALSE(parse_time("2026-13-12T23:59:00Z"));
}

}  // namespace
}  // namespace cs550::gradebook
