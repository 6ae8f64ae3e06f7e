#include "cli/grading/lab_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <sstream>
#include <utility>

#include "cli/handout/handout.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"

namespace cs550::cli {
namespace {

/// The message of a failed test, with its likely causes apart.
struct Message {
  std::string before;
  std::vector<std::string> causes;
  std::string after;
};

constexpr const char* likely = "  likely    ";

Message split(const std::string& text) {
  const std::string label = likely;
  const std::string blank(label.size(), ' ');
  std::istringstream lines(text);
  Message message;
  bool in_causes = false;
  for (std::string line; std::getline(lines, line);) {
    in_causes = line.rfind(label, 0) == 0 || (in_causes && line.rfind(blank, 0) == 0);
    if (in_causes) {
      message.causes.push_back(line.substr(label.size()));
    } else {
      (message.causes.empty() ? message.before : message.after) += line + '\n';
    }
  }
  return message;
}

std::string joined(const Message& message) {
  std::string label = likely;
  std::string text = message.before;
  for (const std::string& cause : message.causes) {
    text += label + cause + '\n';
    label.assign(label.size(), ' ');
  }
  return text + message.after;
}

/// The property and what was expected and got, of a report of a failed check; every other report as it
/// is.
std::string shortened(const std::string& report) {
  std::istringstream lines(report);
  std::string kept;
  bool has_check = false;
  bool is_kept = true;
  for (std::string line; std::getline(lines, line);) {
    const bool continues = line.rfind(std::string(std::string(likely).size(), ' '), 0) == 0;
    if (line.rfind("  ", 0) == 0 && !continues) {
      const std::string label = line.substr(2, line.find(' ', 2) - 2);
      has_check = has_check || label == "expected";
      is_kept = label == "then" || label == "expected" || label == "got";
    }
    if (is_kept) kept += line + '\n';
  }
  return has_check ? kept : report;
}

/// Whether a test was stopped as an endless loop.
bool was_stopped(const Verdict& verdict) { return verdict.ending.rfind("stopped", 0) == 0; }

/// Whether a test ended the program by itself: a crash, a sanitizer's report, an exit.
bool ended_the_program(const Verdict& verdict) {
  return !verdict.ending.empty() && !was_stopped(verdict);
}

bool is_unwritten(const Verdict& verdict) {
  return verdict.message.rfind("not implemented: ", 0) == 0;
}

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
    if (verdict.kind == Verdict::Kind::Failed && !is_unwritten(verdict)) {
      outcomes_.failed.insert(verdict.test.name);
    }
    if (was_stopped(verdict)) outcomes_.stopped.insert(verdict.test.name);
    const bool is_first =
        first_failing_step_.empty() || is_earlier_step(verdict.test.step, first_failing_step_);
    if (verdict.kind == Verdict::Kind::Failed && is_first) first_failing_step_ = verdict.test.step;
    std::vector<std::string>& known = causes_[verdict.test.step];
    for (const std::string& cause : split(verdict.message).causes) {
      if (std::find(known.begin(), known.end(), cause) == known.end()) known.push_back(cause);
    }
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
    left_out_ = true;
    return;
  }
  const auto [known, is_new] = reported_.emplace(verdict.message, verdict.test.name);
  if (!is_new) {
    std::cout << indented("the same as " + known->second, indent);
    return;
  }
  if (!verdict.ending.empty() && !everything_) {
    const auto [first, is_first_one] =
        endings_.emplace(verdict.test.step + verdict.ending, verdict.test.name);
    if (!is_first_one) {
      shortened_ = true;
      std::cout << indented(fmt::format("{}, like {}", verdict.ending, first->second), indent);
      return;
    }
  }
  Message message = split(verdict.message);
  message.causes = causes_to_print(verdict);
  const bool is_first = explained_steps_.insert(verdict.test.step).second;
  if (!is_first && !everything_) {
    const std::string short_form = shortened(message.before + message.after);
    shortened_ = shortened_ || short_form != message.before + message.after;
    message = {short_form, message.causes, ""};
  }
  std::cout << indented(joined(message), indent);
}

/// A test that was not run has no causes. Causes of wrong values explain neither a crash nor an endless
/// loop: they are printed with the first test that compared values.
std::vector<std::string> LabReport::causes_to_print(const Verdict& verdict) {
  if (verdict.kind == Verdict::Kind::Blocked || ended_the_program(verdict)) return {};
  std::vector<std::string>& causes = causes_[verdict.test.step];
  if (was_stopped(verdict)) return first_new(endless_causes(causes, known_causes_, outcomes_));
  return first_new(plausible(std::exchange(causes, {}), known_causes_, outcomes_));
}

/// The first ones explain most failing tests, so a few are enough.
std::vector<std::string> LabReport::first_new(const std::vector<std::string>& causes) {
  constexpr std::size_t most = 3;
  std::vector<std::string> chosen;
  for (const std::string& cause : causes) {
    const bool has_room = everything_ || chosen.size() < most;
    if (has_room && printed_causes_.insert(cause).second) chosen.push_back(cause);
  }
  return chosen;
}

bool LabReport::is_after_first_failure(const Verdict& verdict) const {
  return !everything_ && !first_failing_step_.empty() &&
         is_earlier_step(first_failing_step_, verdict.test.step);
}

/// A test that needs a lab that does not compile is blocked. So a step that failed did so by itself, and
/// comes first.
std::string LabReport::what_to_fix(const std::string& earlier_fault) const {
  const auto blocked =
      std::count_if(verdicts_.begin(), verdicts_.end(), [&](const Verdict& verdict) {
        return verdict.is_blocked_by_other_lab() &&
               fmt::format("lab {}", lab_number_of_step(verdict.blocked_by)) == earlier_fault;
      });
  if (blocked == 0 || first_failing_step_.empty()) {
    return (earlier_fault.empty() ? first_failing_step_ : earlier_fault) + " first";
  }
  return fmt::format("{} first; {} blocks {} test{}", first_failing_step_, earlier_fault, blocked,
                     blocked == 1 ? "" : "s");
}

/// Empty if every report was printed as it is.
std::string LabReport::fate_of_other_reports() const {
  if (left_out_) return shortened_ ? "left out or shortened" : "left out";
  return shortened_ ? "shortened" : "";
}

/// If nothing fails, a student can only go on with the first lab that blocks tests.
void LabReport::print_lab_to_write() const {
  std::map<int, std::vector<Verdict>> blocked;
  for (const Verdict& verdict : verdicts_) {
    if (!verdict.is_blocked_by_other_lab()) continue;
    blocked[lab_number_of_step(verdict.blocked_by)].push_back(verdict);
  }
  if (blocked.empty()) return;
  const auto& [lab, waiting] = *blocked.begin();
  int points = 0;
  for (const Verdict& verdict : waiting) points += verdict.test.points;
  const bool is_one = waiting.size() == 1;
  std::cout << fmt::format("Next: write lab {}. {} {} for it ({} points).\n", lab, waiting.size(),
                           is_one ? "test waits" : "tests wait", points);
}

void LabReport::print_total(int elsewhere, const std::string& earlier_fault) const {
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
  const std::string advice = "Fix " + what_to_fix(earlier_fault) + '.';
  if (const std::string fate = fate_of_other_reports(); !fate.empty()) {
    std::cout << indented(advice + " Other reports are " + fate + "; --all prints them.", 0);
  } else if (!earlier_fault.empty()) {
    std::cout << advice << '\n';
  } else if (first_failing_step_.empty()) {
    print_lab_to_write();
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
