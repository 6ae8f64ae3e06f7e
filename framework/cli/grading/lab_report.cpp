#include "cli/grading/lab_report.hpp"

#include <fmt/format.h>

#include <iostream>
#include <sstream>

#include "cli/handout/handout.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"

namespace cs550::cli {
namespace {

std::string verdict_word(const Verdict& verdict) {
  switch (verdict.kind) {
    case Verdict::Kind::Passed:
      return coloured("passed ", Colour::Green);
    case Verdict::Kind::Blocked:
      return coloured("blocked", Colour::Yellow);
    case Verdict::Kind::Failed:
      return coloured("FAILED ", Colour::Red);
  }
  return {};
}

}  // namespace

void LabReport::print(const std::vector<Verdict>& verdicts) {
  for (const Verdict& verdict : verdicts) {
    if (verdict.kind == Verdict::Kind::Passed) outcomes_.passed.insert(verdict.test.name);
    if (verdict.kind == Verdict::Kind::Failed) outcomes_.failed.insert(verdict.test.name);
    const bool is_first =
        first_failing_step_.empty() || is_earlier_step(verdict.test.step, first_failing_step_);
    if (verdict.kind == Verdict::Kind::Failed && is_first) first_failing_step_ = verdict.test.step;
  }
  for (const Verdict& verdict : verdicts) {
    std::cout << fmt::format("  {} {:>5}  {:<6}{}\n", verdict_word(verdict),
                             fmt::format("{}/{}", verdict.earned(), verdict.test.points),
                             verdict.test.step, verdict.test.name);
    if (verdict.kind != Verdict::Kind::Passed) print_reason(verdict);
    verdicts_.push_back(verdict);
  }
  std::cout << std::flush;
}

/// A reason is printed once; a test with the same one names the test that has it.
void LabReport::print_reason(const Verdict& verdict) {
  constexpr int indent = 6;
  if (is_after_first_failure(verdict)) {
    shortened_ = true;
    return;
  }
  const auto [known, is_new] = reported_.emplace(verdict.message, verdict.test.name);
  std::cout << indented(is_new ? with_new_causes(verdict.message) : "the same as " + known->second,
                        indent);
}

/// Leaves out the likely causes that a passing test excludes, and those that an earlier report has.
std::string LabReport::with_new_causes(const std::string& message) {
  const std::string label = "  likely    ";
  const std::string blank(label.size(), ' ');
  std::istringstream lines(message);
  std::string before;
  std::string after;
  std::vector<std::string> causes;
  bool in_causes = false;
  for (std::string line; std::getline(lines, line);) {
    in_causes = line.rfind(label, 0) == 0 || (in_causes && line.rfind(blank, 0) == 0);
    if (in_causes) {
      causes.push_back(line.substr(label.size()));
    } else {
      (causes.empty() ? before : after) += line + '\n';
    }
  }
  std::string text;
  for (const std::string& cause : plausible(causes, known_causes_, outcomes_)) {
    if (causes_.insert(cause).second) text += (text.empty() ? label : blank) + cause + '\n';
  }
  return before + text + after;
}

bool LabReport::is_after_first_failure(const Verdict& verdict) const {
  return !everything_ && !first_failing_step_.empty() &&
         is_earlier_step(first_failing_step_, verdict.test.step);
}

void LabReport::print_total(int elsewhere) const {
  int earned = 0;
  int points = 0;
  std::size_t passed = 0;
  for (const Verdict& verdict : verdicts_) {
    earned += verdict.earned();
    points += verdict.test.points;
    passed += verdict.kind == Verdict::Kind::Passed ? 1 : 0;
  }
  std::cout << '\n'
            << coloured(fmt::format("{} of {} points, {} of {} tests passed", earned, points,
                                    passed, verdicts_.size()),
                        Colour::Bold)
            << '\n';
  if (shortened_) {
    std::cout << "Fix " << first_failing_step_
              << " first. Reasons in later steps are left out; --all prints them.\n";
  }
  if (elsewhere > 0) std::cout << elsewhere << " more points are graded by your instructor.\n";
}

int give_hint(const Verdict& failure, int number) {
  const std::string& step = failure.step_to_mend();
  if (failure.kind == Verdict::Kind::Blocked) {
    std::cout << failure.test.name << " needs " << step << ", which is not written yet.\n\n";
  }
  return show_hint(lab_of_step(step), step, number);
}

}  // namespace cs550::cli
