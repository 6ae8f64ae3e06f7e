/// The reports that are made from records.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/system/files.hpp"
#include "gradebook/course/course_file.hpp"
#include "gradebook/marks/time_text.hpp"
#include "gradebook/records/record_json.hpp"
#include "gradebook/reports/class_page.hpp"
#include "gradebook/reports/classroom.hpp"
#include "gradebook/reports/feedback.hpp"
#include "gradebook/reports/grades_csv.hpp"
#include "gradebook/reports/gradescope.hpp"
#include "gradebook/reports/junit.hpp"
#include "gradebook/reports/numbers.hpp"
#include "gradebook/reports/statistics.hpp"
#include "gradebook/reports/write_reports.hpp"
#include "gradebook/text/base64.hpp"
#include "gradebook_test.hpp"

namespace cs550::gradebook {
namespace {

using Json = nlohmann::json;

StudentMark mark_of(const Record& record, const Course& course) {
  return mark_student({"ada", "Ada", "", "", {}, true, {&record}}, {3}, course);
}

TEST(Gradescope, HasTheFieldsOfItsFormat) {
  const Record record = record_of("ada", lab_record(24, 0, 12));
  const Course course = course_of(
      "leaderboard = ['points', 'seconds']\n[lab.3]\npoints = 100\n"
      "[visibility]\nhidden_tests = 'after_due_date'\n");
  const Json json = Json::parse(gradescope_json(mark_of(record, course), course));
  EXPECT_DOUBLE_EQ(json.at("score"), 60);
  EXPECT_DOUBLE_EQ(json.at("max_score"), 100);
  EXPECT_DOUBLE_EQ(json.at("execution_time"), 1.5);
  const Json& tests = json.at("tests");
  ASSERT_EQ(tests.size(), 3U);
  EXPECT_DOUBLE_EQ(tests[0].at("score"), 40);
  EXPECT_DOUBLE_EQ(tests[0].at("max_score"), 40);
  EXPECT_EQ(tests[0].at("status"), "passed");
  EXPECT_EQ(tests[0].at("name"), "Lab3.FirstOfEqualVerticesWins");
  EXPECT_EQ(tests[0].at("number"), "3.1");
  EXPECT_EQ(tests[0].at("visibility"), "visible");
  EXPECT_EQ(tests[1].at("output"), "expected 1 m, got 2 m");
  EXPECT_EQ(tests[2].at("visibility"), "after_due_date");
  EXPECT_EQ(tests[2].at("tags"), (Json{"L3.1", "hidden"}));
  EXPECT_EQ(json.at("leaderboard")[0].at("name"), "Points");
  EXPECT_EQ(json.at("leaderboard")[1].at("order"), "asc");
  EXPECT_EQ(json.at("extra_data").at("submission"), "ada");
}

TEST(Gradescope, ShowsNothingOfHiddenTestsBeforeTheirTime) {
  LabRecord lab = lab_record(24, 24, 12);
  lab.challenge = {{"vertices visited", true, 42}};
  const Record record = record_of("ada", lab);
  const auto json_with = [&](Visibility hidden_tests) {
    Course course = course_of("leaderboard = ['points', 'challenge']\n[lab.3]\npoints = 120\n");
    course.hidden_tests = hidden_tests;
    course.regrades = {{"ada", 3, "Lab3.Secret", RegradeRequest::Status::Open, ""}};
    return Json::parse(gradescope_json(mark_of(record, course), course));
  };
  const Json hidden = json_with(Visibility::AfterPublished);
  ASSERT_EQ(hidden.at("leaderboard").size(), 1U) << "a challenge needs the hidden tests";
  EXPECT_DOUBLE_EQ(hidden.at("leaderboard")[0].at("value"), 96);
  EXPECT_EQ(hidden.at("output"), "Lab 3: regrade of a hidden test requested\n");
  const Json visible = json_with(Visibility::Visible);
  EXPECT_EQ(visible.at("leaderboard").size(), 2U);
  EXPECT_DOUBLE_EQ(visible.at("leaderboard")[0].at("value"), 120);
  const std::string output = visible.at("output");
  EXPECT_NE(output.find("60 of 60 points"), std::string::npos) << output;
  EXPECT_NE(output.find("Lab3.Secret"), std::string::npos) << output;
}

TEST(Gradescope, RanksTheChallengesOfFinishedLabs) {
  LabRecord lab = lab_record(24, 24, 12);
  lab.challenge = {{"vertices visited", true, 42}, {"ids kept", false, 7}};
  const Course course =
      course_of("leaderboard = ['challenge', 'points']\n[visibility]\nhidden_tests = 'visible'\n");
  const Record record = record_of("ada", lab_from_json(to_json(lab), "a record"));
  const Json board =
      Json::parse(gradescope_json(mark_of(record, course), course)).at("leaderboard");
  ASSERT_EQ(board.size(), 3U);
  EXPECT_EQ(board[0], (Json{{"name", "Lab 3: vertices visited"}, {"value", 42}, {"order", "asc"}}));
  EXPECT_EQ(board[1], (Json{{"name", "Lab 3: ids kept"}, {"value", 7}, {"order", "desc"}}));
  EXPECT_EQ(board[2].at("name"), "Points");
}

TEST(Junit, CountsVerdictsAndShowsPoints) {
  Record record = record_of("ada", lab_record(24, 0, 0));
  record.labs[0].tests[2].status = "blocked";
  record.labs[0].tests[0].status = "crashed";
  record.labs[0].tests[0].earned = 0;
  const std::string text = junit_xml(record);
  EXPECT_NE(text.find(R"(tests="3" failures="2" errors="1" skipped="0")"), std::string::npos)
      << text;
  EXPECT_NE(text.find("<system-out>points 24, earned 0</system-out>"), std::string::npos);
  EXPECT_NE(text.find(R"(<property name="points" value="12"/>)"), std::string::npos);
  EXPECT_NE(text.find(R"(type="blocked")"), std::string::npos) << "blocked is not passed";
}

TEST(Classroom, ListsVisibleTestsOnly) {
  const Json json = Json::parse(classroom_json(record_of("ada", lab_record(24, 0, 12))));
  EXPECT_EQ(json.at("max_score"), 48);
  EXPECT_EQ(json.at("tests").size(), 2U);
  EXPECT_EQ(json.at("status"), "fail");
  EXPECT_EQ(json.at("tests")[0].at("status"), "pass");
}

TEST(Feedback, ShowsHiddenTestsByNameAndPointsOnly) {
  const Record record = hostile_record();
  for (const bool listed : {true, false}) {
    const Course course = course_of(listed ? "" : "[visibility]\nhidden_tests = 'hidden'\n");
    for (const std::string& text : {feedback_markdown(mark_of(record, course), course),
                                    feedback_html(mark_of(record, course), course)}) {
      EXPECT_EQ(text.find("twin edge"), std::string::npos) << "the message of a hidden test";
      EXPECT_EQ(text.find("Secret") != std::string::npos, listed);
      EXPECT_NE(text.find("12"), std::string::npos) << "the points of hidden tests";
    }
  }
}

TEST(Feedback, MasksTheNamesOfHiddenTestsInNotes) {
  const Record record = record_of("ada", lab_record(24, 0, 0));
  Course course = course_of("[visibility]\nhidden_tests = 'hidden'\n");
  course.regrades = {{"ada", 3, "Lab3.Secret", RegradeRequest::Status::Declined, ""}};
  for (const std::string& text : {feedback_markdown(mark_of(record, course), course),
                                  feedback_html(mark_of(record, course), course)}) {
    EXPECT_EQ(text.find("Secret"), std::string::npos);
    EXPECT_NE(text.find("regrade of a hidden test declined"), std::string::npos);
  }
}

TEST(Feedback, ShowsThePictureOfAVisibleTestOnly) {
  Record record = record_of("ada", lab_record(24, 0, 0));
  for (TestResult& test : record.labs[0].tests) test.picture = "<svg>" + test.name + "</svg>";
  const Course course = course_of("");
  const std::string text = feedback_html(mark_of(record, course), course);
  const auto image = [](const std::string& name) { return base64("<svg>Lab3." + name + "</svg>"); };
  EXPECT_EQ(base64("foob"), "Zm9vYg==") << "RFC 4648, section 10";
  EXPECT_NE(text.find("src=\"data:image/svg+xml;base64," + image("ClimbEndsOnAPlateau")),
            std::string::npos);
  EXPECT_EQ(text.find(image("Secret")), std::string::npos) << "a hidden test";
  EXPECT_EQ(text.find(image("FirstOfEqualVerticesWins")), std::string::npos)
      << "a test that passed";
}

TEST(Reports, ClassPageShowsNoMessageOfAHiddenTest) {
  Record ada = hostile_record();
  Record bob = hostile_record();
  bob.name = bob.student = "bob";
  const std::vector<Record> records{ada, bob};
  const Course course = course_of("");
  const std::string text = class_page(mark_class(assign({}, records), {3}, course), {3}, course);
  EXPECT_NE(text.find("Lab3.Secret"), std::string::npos);
  EXPECT_NE(text.find("(a hidden test)"), std::string::npos);
  EXPECT_EQ(text.find("twin edge"), std::string::npos);
}

TEST(Reports, NoReportContainsWhatAStudentWroteAsMarkup) {
  const std::vector<Record> records{hostile_record(), record_of("bob", lab_record(0, 24, 0))};
  const Course course = course_of("title = '<script>title</script>'");
  const StudentMark mark = mark_of(records[0], course);
  const std::vector<StudentMark> marks = mark_class(assign({}, records), {3}, course);
  for (const std::string& text :
       {feedback_html(mark, course), class_page(marks, {3}, course), junit_xml(records[0])}) {
    EXPECT_EQ(text.find("<script>"), std::string::npos);
    EXPECT_EQ(text.find("<img"), std::string::npos);
    EXPECT_EQ(text.find('\033'), std::string::npos);
    EXPECT_EQ(text.find('\xFF'), std::string::npos);
  }
  const std::string markdown = feedback_markdown(mark, course);
  EXPECT_NE(markdown.find("````text\n<script>"), std::string::npos) << "a fence longer than theirs";
  for (const std::string& text : {gradescope_json(mark, course), classroom_json(records[0])}) {
    EXPECT_TRUE(Json::accept(text)) << text;
    EXPECT_EQ(text.find("\\u001b"), std::string::npos);
  }
}

TEST(Reports, AreMadeFromRecordsAlone) {
  const ScratchFolder scratch;
  const std::vector<Record> records{record_of("ada", lab_record(24, 0, 12))};
  write_reports(scratch / "a", records, {}, course_of(""));
  write_reports(scratch / "b", records, {}, course_of(""));
  for (const char* file : {"grades.csv", "class.html", "gradescope/ada.json", "junit/ada.xml",
                           "classroom/ada.json", "feedback/ada.md", "feedback/ada.html"}) {
    EXPECT_EQ(cli::read_text(scratch / "a" / file), cli::read_text(scratch / "b" / file)) << file;
  }
}

std::vector<Record> class_of(const std::vector<std::pair<int, int>>& points) {
  std::vector<Record> records;
  for (const auto& [first, second] : points) {
    records.push_back(
        record_of("s" + std::to_string(records.size()), lab_record(first, second, 0)));
    records.back().labs[0].hash = records.back().name;
  }
  return records;
}

TEST(Statistics, DescribeLabsAndTests) {
  const std::vector<Record> records = class_of({{24, 24}, {24, 24}, {24, 0}, {0, 0}});
  const std::vector<StudentMark> marks = mark_class(assign({}, records), {3}, course_of(""));
  const ClassStatistics statistics = statistics_of(marks, {3});
  ASSERT_EQ(statistics.labs.size(), 1U);
  EXPECT_EQ(statistics.labs[0].submissions, 4);
  EXPECT_DOUBLE_EQ(statistics.labs[0].mean, 50);
  EXPECT_DOUBLE_EQ(statistics.labs[0].median, 60);
  EXPECT_EQ(statistics.labs[0].histogram[8], 2);
  EXPECT_EQ(statistics.labs[0].histogram[0], 1);
  EXPECT_EQ(statistics.tests[0].passed, 3);
  // r of (1, 1, 1, 0) and (24, 24, 0, 0)
  EXPECT_NEAR(statistics.tests[0].discrimination, 1 / std::sqrt(3.0), 1e-9);
  EXPECT_FALSE(statistics.tests[2].discriminates) << "everyone failed it";
}

TEST(Statistics, AlikeFailuresDifferInNumbersOnly) {
  std::vector<Record> records = class_of({{0, 24}, {0, 24}, {0, 24}});
  records[0].labs[0].tests[0].message = "expected 1.25 m, got 2 m\nseed 1";
  records[1].labs[0].tests[0].message = "expected 13.5 m, got 40 m\nseed 2";
  records[2].labs[0].tests[0].message = "the program crashed";
  for (Record& record : records) record.labs[0].tests[2].message.clear();
  const std::vector<StudentMark> marks = mark_class(assign({}, records), {3}, course_of(""));
  const std::vector<AlikeFailures> failures = statistics_of(marks, {3}).failures;
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_EQ(failures[0].message, "expected #.# m, got # m");
  EXPECT_EQ(failures[0].students.size(), 2U);
}

TEST(Statistics, EqualFilesAreListed) {
  std::vector<Record> records = class_of({{24, 24}, {24, 24}, {24, 24}, {0, 0}, {0, 0}});
  records[0].labs[0].hash = records[2].labs[0].hash = "the same";
  records[3].labs[0].hash = records[4].labs[0].hash = "the starter";
  const std::vector<StudentMark> marks = mark_class(assign({}, records), {3}, course_of(""));
  const std::vector<EqualFiles> equal = statistics_of(marks, {3}).equal;
  ASSERT_EQ(equal.size(), 1U) << "files that earn nothing are equal by chance";
  EXPECT_EQ(equal[0].students[1]->student.id, "s2");
}

TEST(Statistics, OutliersAreAmongStudentsWithAMark) {
  std::vector<Record> records = class_of(std::vector<std::pair<int, int>>(9, {24, 24}));
  for (Record& record : records) {
    record.labs.resize(3, record.labs[0]);
    for (int i = 0; i < 3; ++i) record.labs[static_cast<std::size_t>(i)].lab = 3 + i;
  }
  for (TestResult& test : records[8].labs[0].tests) test.earned = 0;
  const auto outliers = [&] {
    const std::vector<StudentMark> marks =
        mark_class(assign({}, records), {3, 4, 5}, course_of(""));
    return statistics_of(marks, {3, 4, 5}).outliers.size();
  };
  EXPECT_EQ(outliers(), 2U) << "in all, and in lab 3";
  records[8].labs[0].not_graded = "the judge broke";
  EXPECT_EQ(outliers(), 0U);
}

TEST(Statistics, OfNumbers) {
  EXPECT_DOUBLE_EQ(median_of({3, 1, 2}), 2);
  EXPECT_DOUBLE_EQ(median_of({4, 1, 2, 3}), 2.5);
  EXPECT_DOUBLE_EQ(deviation_of({1, 3}), 1);
  EXPECT_DOUBLE_EQ(*correlation({1, 2, 3}, {-2, -4, -6}), -1);
  EXPECT_FALSE(correlation({1, 2}, {5, 5}));
  EXPECT_DOUBLE_EQ(mean_of({}), 0);
}

TEST(Reports, ClassPageShowsHowManyReachEachMilestone) {
  const std::vector<Record> records{
      with_engine(record_of("ada", lab_record(24, 0, 0)), {"passed", "passed"}),
      with_engine(record_of("bob", lab_record(24, 0, 0)), {"passed", "failed"}),
      record_of("eve", lab_record(24, 0, 0))};
  const Course course = course_of("");
  const std::string text = class_page(mark_class(assign({}, records), {3}, course), {3}, course);
  EXPECT_NE(text.find("Milestone.1</td><td class=\"number\">2 of 2</td>"), std::string::npos);
  EXPECT_NE(text.find("Milestone.2</td><td class=\"number\">1 of 2</td>"), std::string::npos);
  EXPECT_NE(text.find("feedback/bob.html\">1 of 2</a>"), std::string::npos);
  const std::vector<Record> without{records[2]};
  EXPECT_EQ(class_page(mark_class(assign({}, without), {3}, course), {3}, course).find("ilestone"),
            std::string::npos);
}

TEST(Feedback, SaysWhichOfSeveralSubmissionsCounts) {
  Record first = record_of("ada", lab_record(24, 0, 0));
  Record second = record_of("ada", lab_record(24, 24, 0));
  first.source = "ada-lab3.zip";
  second.name = "ada-2";
  second.source = "ada-lab3-again.zip";
  const ScratchFolder scratch;
  write_reports(scratch / "out", {first, second}, {}, course_of(""));
  const std::string of_first = cli::read_text(scratch / "out/feedback/ada.html");
  EXPECT_NE(of_first.find("not what counts: that is ada-lab3-again.zip"), std::string::npos);
  const std::string of_second = cli::read_text(scratch / "out/feedback/ada-2.html");
  EXPECT_EQ(of_second.find("not what counts"), std::string::npos);
}

TEST(Feedback, ShowsNoMarkIfAnotherSubmissionWasNotGraded) {
  const Record first = record_of("ada", lab_record(24, 0, 0));
  Record second = record_of("ada", lab_record(0, 0, 0));
  second.name = "ada-2";
  second.source = "ada-again.zip";
  second.labs[0].not_graded = "the judge broke";
  const ScratchFolder scratch;
  write_reports(scratch / "out", {first, second}, {}, course_of(""));
  for (const char* file : {"out/feedback/ada.md", "out/feedback/ada.html"}) {
    const std::string text = cli::read_text(scratch / file);
    EXPECT_NE(text.find("Lab 3: not graded"), std::string::npos) << text;
    EXPECT_NE(text.find("the grader failed on ada"), std::string::npos) << text;
  }
}

TEST(Reports, ShowNoNumberOfMilestonesThatWereNotGraded) {
  const Record ada = record_of("ada", lab_record(24, 0, 0));
  const std::vector<Record> records{
      with_broken_engine(ada, 2),
      with_engine(record_of("bob", lab_record(24, 0, 0)), {"passed", "failed"})};
  for (const char* weight : {"", "[milestones]\nweight = 1\n"}) {
    const Course course = course_of(weight);
    const std::vector<StudentMark> marks = mark_class(assign({}, records), {3}, course);
    EXPECT_EQ(marks[0].is_graded(), course.milestones_weight == 0);
    const std::string page = class_page(marks, {3}, course);
    EXPECT_NE(page.find("feedback/ada.html\">–</a>"), std::string::npos) << page;
    EXPECT_NE(page.find("Milestone.1</td><td class=\"number\">1 of 1</td>"), std::string::npos);
    for (const std::string& text :
         {feedback_markdown(marks[0], course), feedback_html(marks[0], course)}) {
      EXPECT_NE(text.find("Engine: not graded"), std::string::npos) << text;
    }
    const std::string csv = grades_csv(marks, {3});
    EXPECT_NE(csv.find(",24,,milestones NOT GRADED"), std::string::npos) << csv;
  }
}

TEST(Reports, ClassPageShowsThatNobodysMilestonesWereGraded) {
  const Course course = course_of("");
  const std::vector<Record> records{with_broken_engine(record_of("ada", lab_record(24, 0, 0)), 2)};
  const std::string page = class_page(mark_class(assign({}, records), {3}, course), {3}, course);
  EXPECT_NE(page.find("feedback/ada.html\">–</a>"), std::string::npos) << page;
  EXPECT_EQ(page.find("<h2>Milestones"), std::string::npos) << "nothing to count";
}

TEST(Statistics, CountNoMilestonesOfAStudentWhoseOtherEngineBroke) {
  const Record first = with_engine(record_of("ada", lab_record(24, 0, 0)), {"passed", "failed"});
  Record second = with_broken_engine(record_of("ada", lab_record(24, 0, 0)), 2);
  second.name = "ada-2";
  const std::vector<Record> records{first, second};
  const std::vector<StudentMark> marks = mark_class(assign({}, records), {3}, course_of(""));
  ASSERT_EQ(marks.size(), 1U);
  EXPECT_TRUE(statistics_of(marks, {3}).milestones.empty());
}

TEST(Feedback, ListsTestsInTheOrderOfTheSteps) {
  Record record = record_of("ada", lab_record(24, 24, 12));
  record.labs[0].tests[0].step = "L3.10";
  record.labs[0].tests[1].step = "L3.2";
  const std::string text = feedback_markdown(mark_of(record, course_of("")), course_of(""));
  EXPECT_LT(text.find("L3.2 "), text.find("L3.10 ")) << text;
}

TEST(Feedback, DoesNotShowWhyTheGraderFailed) {
  Record record = record_of("ada", lab_record(24, 24, 12));
  record.labs[0].own_tests = OwnTests{};
  record.labs[0].own_tests->not_graded = "cannot read /secret/mistakes";
  const Course course = course_of("[lab.3]\nown_tests = 5\n");
  const StudentMark mark = mark_of(record, course);
  EXPECT_EQ(feedback_markdown(mark, course).find("secret"), std::string::npos);
  EXPECT_EQ(feedback_html(mark, course).find("secret"), std::string::npos);
  EXPECT_NE(feedback_markdown(mark, course).find("NOT GRADED"), std::string::npos);
}

TEST(Reports, ClassPageCountsTheStudentsOfTheRoster) {
  const std::vector<Record> records{record_of("ada", lab_record(24, 0, 0)),
                                    record_of("nobody", lab_record(24, 0, 0))};
  std::vector<Student> roster(3);
  for (std::size_t i = 0; i < roster.size(); ++i)
    roster[i].id = i == 0 ? "ada" : fmt::format("s{}", i);
  const Course course = course_of("");
  const std::string text =
      class_page(mark_class(assign(roster, records), {3}, course), {3}, course);
  EXPECT_NE(text.find("3 students, 2 without a submission. 1 name is not on the roster."),
            std::string::npos);
  EXPECT_NE(text.find("2 submitted, 2 missing"), std::string::npos);
}

TEST(GradesCsv, ListsMissingStudentsAndEscapesNames) {
  std::vector<Record> records{record_of("=cmd", lab_record(24, 0, 0))};
  const std::vector<Student> students = assign(parse_roster("id\nada\n", "r"), records);
  const std::string text = grades_csv(mark_class(students, {3}, course_of("")), {3});
  EXPECT_EQ(text,
            "id,name,email,section,status,percent,lab3,notes\n"
            "ada,,,,missing,0.00,,\n"
            "'=cmd,,,,not on the roster,40.00,24,\n");
}

TEST(Reports, NameAStudentWithoutALabThatIsGraded) {
  LabRecord none;
  none.lab = 3;
  std::vector<Record> records{record_of("ada", none), record_of("bob", none)};
  records[1].trouble = "the archive is damaged";
  const std::vector<Student> students = assign(parse_roster("id\nada\nbob\n", "r"), records);
  const std::string text = grades_csv(mark_class(students, {3}, course_of("")), {3});
  EXPECT_NE(text.find("\nada,,,,no graded lab,0.00,"), std::string::npos) << text;
  EXPECT_NE(text.find("\nbob,,,,unreadable,0.00,"), std::string::npos) << text;
  const std::string page = class_page(mark_class(students, {3}, course_of("")), {3}, course_of(""));
  EXPECT_NE(page.find("no graded lab"), std::string::npos) << page;
  EXPECT_NE(page.find("the archive is damaged"), std::string::npos) << page;
}

TEST(GradesCsv, NotesWhatAnInstructorMayWantToLookAt) {
  LabRecord broken = lab_record(0, 0, 0);
  broken.compiled = false;
  LabRecord slow = lab_record(24, 0, 0);
  for (const char* status : {"timeout", "crashed", "timeout", "failed"}) {
    slow.tests.emplace_back().status = status;
  }
  std::vector<Record> records{record_of("ada", broken), record_of("bob", slow)};
  const std::vector<Student> students = assign(parse_roster("id\nada\nbob\n", "r"), records);
  const std::string text = grades_csv(mark_class(students, {3}, course_of("")), {3});
  EXPECT_NE(text.find("lab 3: does not compile"), std::string::npos) << text;
  EXPECT_NE(text.find("lab 3: 1 test crashed; lab 3: 2 tests ended at the limit of time"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace cs550::gradebook
