#include "standing_view.hpp"

#include <algorithm>
#include <iostream>
#include <sstream>
#include <string>

#include "engine_score.hpp"
#include "handout.hpp"
#include "hints.hpp"
#include "lab_report.hpp"
#include "manifest.hpp"
#include "project.hpp"
#include "terminal.hpp"
#include "verb.hpp"

namespace cs550::cli {

namespace {

/// Twenty cells for 0 to 1; the last one only for all of it.
std::string bar(int part, int whole) {
  constexpr int cells = 20;
  const int full = whole > 0 ? cells * part / whole : 0;
  std::string text;
  for (int i = 0; i < cells; ++i) text += i < full ? '#' : '.';
  return '[' + text + ']';
}

std::string points(int earned, int all) {
  std::ostringstream text;
  text << earned << '/' << all;
  return std::string(std::max<std::size_t>(7, text.str().size()) - text.str().size(), ' ') +
         text.str();
}

std::string remark(const Standing& standing, const LabResult& lab) {
  if (!lab.compile_error.empty()) return coloured("does not compile", Colour::Red);
  if (lab.is_finished()) return coloured("done", Colour::Green);
  if (standing.untouched.count(lab.lab_name) != 0) return coloured("not begun", Colour::Faint);
  return "at " + lab.next_failure()->test.step;
}

/// At most so many lines of a text.
std::string first_lines(const std::string& text, int count) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    if (count-- == 0) return result + "...\n";
    result += line + '\n';
  }
  return result;
}

/// The second score: do the labs work together?
void print_engine(const Standing& standing) {
  const int reached = static_cast<int>(standing.milestones.size());
  const auto all = static_cast<int>(
      std::count_if(standing.labs.begin(), standing.labs.end(),
                    [](const LabResult& lab) { return has_milestone(lab_number(lab.lab_name)); }));
  std::cout << padded("Your engine, assembled", 27) << bar(reached, all) << points(reached, all)
            << "  milestones";
  for (const LabResult& lab : standing.labs) {
    const int number = lab_number(lab.lab_name);
    if (!has_milestone(number) || standing.milestones.count(number) != 0) continue;
    if (lab.is_finished()) std::cout << "; lab " << number << " --run";
    break;
  }
  std::cout << '\n';
}

void print_labs(const Standing& standing) {
  int earned = 0;
  int all = 0;
  int elsewhere = 0;
  for (const LabResult& lab : standing.labs) {
    std::cout << padded(title(lab.lab_name), 27) << bar(lab.earned(), lab.points())
              << points(lab.earned(), lab.points()) << "  " << remark(standing, lab) << '\n';
    earned += lab.earned();
    all += lab.points();
    elsewhere += points_graded_elsewhere(lab.lab_name);
  }
  std::cout << coloured(padded("Together", 27) + bar(earned, all) + points(earned, all),
                        Colour::Bold)
            << (elsewhere > 0 ? "  and " + std::to_string(elsewhere) + " by instructor" : "")
            << '\n';
  print_engine(standing);
}

}  // namespace

void print_next(const Standing& standing, int lines) {
  if (!standing.next) {
    std::cout << "\nEvery test passes. To see your engine at work: ./cs550 lab "
              << lab_number(standing.labs.back().lab_name) << " --run\n";
    return;
  }
  const LabResult& lab = standing.labs[*standing.next];
  if (!lab.compile_error.empty()) {
    std::cout << "\nNext: " << coloured(title(lab.lab_name) + " does not compile", Colour::Bold)
              << '\n'
              << first_lines(indented(lab.compile_error, 4), lines);
    return;
  }
  const Verdict failure = *lab.next_failure();
  const Step step = handout_step(lab.lab_name, failure.test.step);
  std::cout << "\nNext: " << coloured(step.tag + ' ' + step.title, Colour::Bold) << "   (labs/"
            << lab.lab_name << "/README.md)\n";
  std::cout << "  " << failure.test.name << ", " << failure.test.points << " points:\n"
            << first_lines(indented(failure.message, 4), lines);
}

void print_tests(const Standing& standing) {
  if (!standing.next) return print_next(standing, 0);
  const LabResult& lab = standing.labs[*standing.next];
  std::cout << coloured(title(lab.lab_name), Colour::Bold) << "\n\n";
  if (!lab.compile_error.empty()) {
    std::cout << indented(lab.compile_error, 2);
    return;
  }
  for (const Verdict& verdict : lab.verdicts) {
    const bool passed = verdict.kind == Verdict::Kind::Passed;
    std::cout << "  "
              << coloured(padded(to_string(verdict.kind), 8), passed ? Colour::Green : Colour::Red)
              << points(verdict.earned(), verdict.test.points) << "  "
              << padded(verdict.test.step, 6) << verdict.test.name << '\n';
  }
}

int print_hint(const Standing& standing) {
  if (!standing.next) {
    print_next(standing, 0);
    return Good;
  }
  const LabResult& lab = standing.labs[*standing.next];
  return show_hint(lab.lab_name, lab.next_failure()->test.step, 0);
}

void print_overview(const Standing& standing) {
  constexpr int lines_of_reason = 9;  // all of it fits into 24 lines
  print_labs(standing);
  print_next(standing, lines_of_reason);
}

}  // namespace cs550::cli
