#include <fmt/format.h>

#include "gradebook/reports/feedback.hpp"
#include "gradebook/reports/shown.hpp"
#include "gradebook/text/escape.hpp"

namespace cs550::gradebook {
namespace {

std::string test_rows(const LabRecord& lab, const Course& course) {
  std::string text = "| Step | Test | Points | Result |\n|---|---|---|---|\n";
  int hidden_points = 0;
  int hidden_earned = 0;
  for (const TestResult& test : by_step(lab.tests)) {
    if (test.hidden && !lists_hidden_tests(course)) {
      hidden_points += test.points;
      hidden_earned += test.earned;
      continue;
    }
    text += fmt::format("| {} | {} | {} of {} | {} |\n", markdown(test.step),
                        test.hidden ? markdown(test.name) + " (hidden)" : markdown(test.name),
                        test.earned, test.points, markdown(status_text(test)));
  }
  if (hidden_points > 0) {
    text += fmt::format("| | hidden tests | {} of {} | |\n", hidden_earned, hidden_points);
  }
  return text;
}

std::string failures(const LabRecord& lab) {
  std::string text;
  for (const TestResult& test : by_step(lab.tests)) {
    if (test.status == "passed" || shown_message(test).empty()) continue;
    text += fmt::format("\n### {}\n\n{}", markdown(test.name), markdown_block(test.message));
  }
  return text;
}

std::string lab_in_markdown(const LabMark& mark, const Course& course) {
  std::string text = "\n## " + lab_heading(mark) + "\n\n";
  for (const std::string& note : mark.notes) {
    text += "- " + markdown(note_in_feedback(note, mark, course)) + '\n';
  }
  const LabRecord* lab = mark.lab_record();
  if (lab == nullptr) return text;
  for (const std::string& file : lab->supplied) {
    text += fmt::format("- {} was not submitted; the starter was used\n", markdown(file));
  }
  text += mark.notes.empty() && lab->supplied.empty() ? "" : "\n";
  if (!lab->compile_errors.empty()) {
    text +=
        "The code " + compile_verdict(*lab) + ":\n\n" + markdown_block(lab->compile_errors) + '\n';
  }
  return text + test_rows(*lab, course) + failures(*lab);
}

/// The student's labs together, as one engine.
std::string engine_in_markdown(const StudentMark& mark) {
  const std::string heading = engine_heading(mark);
  if (heading.empty()) return {};
  const LabRecord& engine = *mark.engine.record->engine;
  std::string text = "\n## " + heading + "\n\n";
  if (!engine.compile_errors.empty()) text += markdown_block(engine.compile_errors) + '\n';
  text += "| Milestone | Result |\n|---|---|\n";
  for (const TestResult& test : engine.tests) {
    text += fmt::format("| {} | {} |\n", markdown(test.name), markdown(milestone_text(test)));
  }
  return text + failures(engine);
}

}  // namespace

std::string feedback_markdown(const StudentMark& mark, const Course& course) {
  const Record& record = *mark.student.records.front();
  std::string text =
      fmt::format("# {}\n\n{}: {}\n", markdown(course.title),
                  markdown(mark.student.name.empty() ? mark.student.id : mark.student.name),
                  markdown(record.source));
  if (!record.trouble.empty()) {
    text += "\n**The submission could not be graded:** " + markdown(record.trouble) + '\n';
  }
  for (const LabMark& lab : mark.labs) {
    if (lab.record != nullptr || lab.mark > 0) text += lab_in_markdown(lab, course);
  }
  text += engine_in_markdown(mark);
  if (const std::string missing = missing_labs(mark); !missing.empty()) {
    text += '\n' + missing + ".\n";
  }
  if (!record.ignored.empty()) text += "\n## Files that were ignored\n\n";
  for (const IgnoredFile& file : record.ignored) {
    text += fmt::format("- {}: {}\n", markdown(file.path), markdown(file.reason));
  }
  text += fmt::format("\nSubmission {}, graded with project {}.\n", record.hash.substr(0, 12),
                      markdown(record.project.substr(0, 12)));
  return text;
}

}  // namespace cs550::gradebook
