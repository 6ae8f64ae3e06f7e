#include <fmt/format.h>

#include "gradebook/reports/feedback.hpp"
#include "gradebook/reports/page.hpp"
#include "gradebook/reports/shown.hpp"
#include "gradebook/text/base64.hpp"
#include "gradebook/text/escape.hpp"

namespace cs550::gradebook {
namespace {

/// As an image, in which no script runs.
std::string picture(const TestResult& test) {
  if (test.picture.empty()) return {};
  return fmt::format("<img alt=\"the case that fails\" src=\"data:image/svg+xml;base64,{}\">",
                     base64(test.picture));
}

std::string test_row(const TestResult& test) {
  const bool passed = test.status == "passed";
  std::string text = fmt::format(
      "<tr><td>{}</td><td>{}{}</td><td class=\"number\">{} / {}</td><td "
      "class=\"{}\">{}</td></tr>\n",
      html(test.step), html(test.name), test.hidden ? " <small>hidden</small>" : "", test.earned,
      test.points, passed ? "good" : "bad", html(status_text(test)));
  if (!passed && !shown_message(test).empty()) {
    text += fmt::format("<tr><td></td><td colspan=\"3\"><pre>{}</pre>{}</td></tr>\n",
                        html(test.message), picture(test));
  }
  return text;
}

std::string test_table(const LabRecord& lab, const Course& course) {
  std::string rows;
  int hidden_points = 0;
  int hidden_earned = 0;
  for (const TestResult& test : by_step(lab.tests)) {
    if (!test.hidden || lists_hidden_tests(course)) {
      rows += test_row(test);
    } else {
      hidden_points += test.points;
      hidden_earned += test.earned;
    }
  }
  if (hidden_points > 0) {
    rows += fmt::format(
        "<tr><td></td><td>hidden tests</td><td class=\"number\">{} / {}</td>"
        "<td></td></tr>\n",
        hidden_earned, hidden_points);
  }
  return table({"Step", "Test", "Points", "Result"}, rows);
}

std::string lab_section(const LabMark& mark, const Course& course) {
  std::string text = "<h2>" + lab_heading(mark) + "</h2>\n";
  std::string notes;
  for (const std::string& note : mark.notes) {
    notes += "<li>" + html(note_in_feedback(note, mark, course)) + "</li>\n";
  }
  const LabRecord* lab = mark.lab_record();
  if (lab != nullptr) {
    for (const std::string& file : lab->supplied) {
      notes += "<li>" + html(file) + " was not submitted; the starter was used</li>\n";
    }
  }
  if (!notes.empty()) text += "<ul>\n" + notes + "</ul>\n";
  if (lab == nullptr) return text;
  if (!lab->compile_errors.empty()) {
    text += fmt::format("<p class=\"bad\">The code {}:</p>\n<pre>{}</pre>\n", compile_verdict(*lab),
                        html(lab->compile_errors));
  }
  return text + test_table(*lab, course);
}

/// The student's labs together, as one engine.
std::string engine_section(const StudentMark& mark) {
  const std::string heading = engine_heading(mark);
  if (heading.empty()) return {};
  const LabRecord& engine = *mark.engine.record->engine;
  std::string text = "<h2>" + heading + "</h2>\n";
  if (!engine.compile_errors.empty()) text += "<pre>" + html(engine.compile_errors) + "</pre>\n";
  std::string rows;
  for (const TestResult& test : engine.tests) {
    const bool reached = test.status == "passed";
    rows += fmt::format("<tr><td>{}</td><td class=\"{}\">{}</td></tr>\n", html(test.name),
                        reached ? "good" : "bad", html(milestone_text(test)));
    if (!reached && !test.message.empty()) {
      rows += "<tr><td colspan=\"2\"><pre>" + html(test.message) + "</pre></td></tr>\n";
    }
  }
  return text + table({"Milestone", "Result"}, rows);
}

}  // namespace

std::string feedback_html(const StudentMark& mark, const Course& course) {
  const Record& record = *mark.student.records.front();
  const std::string name = mark.student.name.empty() ? mark.student.id : mark.student.name;
  std::string body = fmt::format("<h1>{}</h1>\n<p>{}: {}</p>\n", html(course.title), html(name),
                                 html(record.source));
  if (!record.trouble.empty()) {
    body +=
        "<p class=\"bad\">The submission could not be graded: " + html(record.trouble) + "</p>\n";
  }
  for (const LabMark& lab : mark.labs) {
    if (lab.record != nullptr || lab.mark > 0) body += lab_section(lab, course);
  }
  body += engine_section(mark);
  if (const std::string missing = missing_labs(mark); !missing.empty()) {
    body += "<p>" + missing + ".</p>\n";
  }
  if (!record.ignored.empty()) {
    std::string files;
    for (const IgnoredFile& file : record.ignored) {
      files += "<li><code>" + html(file.path) + "</code>: " + html(file.reason) + "</li>\n";
    }
    body += details("Files that were ignored", "<ul>\n" + files + "</ul>\n");
  }
  body += fmt::format("<footer>Submission {}, graded with project {}.</footer>\n",
                      html(record.hash.substr(0, 12)), html(record.project.substr(0, 12)));
  return page(course.title + ": " + name, body);
}

}  // namespace cs550::gradebook
