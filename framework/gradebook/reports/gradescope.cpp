#include "gradebook/reports/gradescope.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "gradebook/reports/shown.hpp"
#include "gradebook/text/escape.hpp"

namespace cs550::gradebook {
namespace {

using Json = nlohmann::ordered_json;

Visibility visibility_of(const TestResult& test, const Course& course) {
  return test.hidden ? course.hidden_tests : course.visible_tests;
}

/// Whether students see every test at once, as they see the texts above the tests and the leaderboard.
bool shows_all(const Course& course) {
  return course.hidden_tests == Visibility::Visible && course.visible_tests == Visibility::Visible;
}

const char* word(Visibility visibility) {
  switch (visibility) {
    case Visibility::Visible:
      return "visible";
    case Visibility::Hidden:
      return "hidden";
    case Visibility::AfterDueDate:
      return "after_due_date";
    case Visibility::AfterPublished:
      return "after_published";
  }
  return "hidden";
}

double rounded(double points) { return std::round(points * 1e4) / 1e4; }

Json test_json(const TestResult& test, double scale, const Course& course) {
  return {{"score", rounded(test.earned * scale)},
          {"max_score", rounded(test.points * scale)},
          {"status", test.status == "passed" ? "passed" : "failed"},
          {"name", test.name},
          {"number", test.step.substr(test.step.starts_with('L') ? 1 : 0)},
          {"output", plain_text(shown_message(test))},
          {"visibility", word(visibility_of(test, course))},
          {"tags", {test.step, test.hidden ? "hidden" : "visible"}}};
}

/// What the tests earn that students see at once, on the scale of the course.
double visible_points(const StudentMark& mark, const Record& record, const Course& course) {
  double sum = 0;
  for (const LabMark& lab : mark.labs) {
    const LabRecord& of_lab = *record.lab(lab.lab);
    for (const TestResult& test : of_lab.tests) {
      if (visibility_of(test, course) != Visibility::Visible) continue;
      sum += test.earned * lab.points / of_lab.points();
    }
  }
  return sum;
}

/// The challenges of the labs that pass every test, also the hidden ones.
void add_challenges(const StudentMark& mark, const Record& record, Json& board) {
  for (const LabMark& lab : mark.labs) {
    for (const ChallengeResult& one : record.lab(lab.lab)->challenge) {
      board.push_back({{"name", fmt::format("Lab {}: {}", lab.lab, one.what)},
                       {"value", one.count},
                       {"order", one.fewer_is_better ? "asc" : "desc"}});
    }
  }
}

Json leaderboard(const StudentMark& mark, const Course& course, double score, double seconds) {
  const Record& record = *mark.student.records.front();
  const double points = shows_all(course) ? score : visible_points(mark, record, course);
  Json board = Json::array();
  for (const std::string& entry : course.leaderboard) {
    if (entry == "points") {
      board.push_back({{"name", "Points"}, {"value", rounded(points)}, {"order", "desc"}});
    } else if (entry == "challenge") {
      if (shows_all(course)) add_challenges(mark, record, board);
    } else {
      board.push_back({{"name", "Seconds"}, {"value", rounded(seconds)}, {"order", "asc"}});
    }
  }
  return board;
}

/// A note on a lab; empty if it would reveal the points of all tests.
std::string shown_note(const std::string& note, const LabMark& lab, const Course& course) {
  if (shows_all(course) || lab.lab_record() == nullptr) return note;
  return note == note_on_scale(lab) ? "" : without_hidden_names(note, *lab.lab_record());
}

/// What is said above the tests.
std::string summary(const StudentMark& mark, const Record& record, const Course& course) {
  std::string text = record.trouble.empty() ? "" : "Not readable: " + record.trouble + '\n';
  for (const LabMark& lab : mark.labs) {
    const LabRecord* of_lab = lab.lab_record();
    for (const std::string& note : lab.notes) {
      const std::string shown = shown_note(note, lab, course);
      if (!shown.empty()) text += fmt::format("Lab {}: {}\n", lab.lab, shown);
    }
    if (of_lab != nullptr && !of_lab->compile_errors.empty()) {
      text += fmt::format("Lab {} {}:\n{}\n", lab.lab, compile_verdict(*of_lab),
                          of_lab->compile_errors);
    }
  }
  return plain_text(text);
}

}  // namespace

std::string gradescope_json(const StudentMark& mark, const Course& course) {
  const Record& record = *mark.student.records.front();
  Json tests = Json::array();
  Json labs = Json::array();
  double score = 0;
  double most = 0;
  double seconds = 0;
  for (const LabMark& lab : mark.labs) {
    const LabRecord& of_lab = *record.lab(lab.lab);
    score += lab.mark;
    most += lab.points;
    seconds += of_lab.seconds();
    const double scale = of_lab.points() == 0 ? 0 : lab.points / of_lab.points();
    for (const TestResult& test : of_lab.tests) tests.push_back(test_json(test, scale, course));
    labs.push_back({{"lab", lab.lab},
                    {"hash", of_lab.hash},
                    {"seed", of_lab.seed},
                    {"isolation", of_lab.isolation},
                    {"compiler", of_lab.compiler},
                    {"late_days", lab.late_days}});
  }
  Json json{
      {"score", rounded(score)},
      {"max_score", rounded(most)},
      {"execution_time", rounded(seconds)},
      {"output", summary(mark, record, course)},
      {"visibility", "visible"},
      {"stdout_visibility", "hidden"},
      {"tests", tests},
      {"extra_data", {{"submission", record.hash}, {"project", record.project}, {"labs", labs}}}};
  if (!course.leaderboard.empty()) json["leaderboard"] = leaderboard(mark, course, score, seconds);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace cs550::gradebook
