// ./cs550 progress: the labs, the points, and what to do next.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/grading/lab_files.hpp"
#include "cli/grading/lab_report.hpp"
#include "cli/grading/standing.hpp"
#include "cli/handout/handout.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"
#include "cli/verb.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;

namespace {

struct ProgressOptions {
  bool watch = false;
  bool list = false;
  bool hint = false;
  bool next = false;
};

/// Twenty cells; the last one is filled only when all is done.
std::string bar(int part, int whole) {
  constexpr int cells = 20;
  const int full = whole > 0 ? cells * part / whole : 0;
  std::string text;
  for (int i = 0; i < cells; ++i) text += i < full ? '#' : '.';
  return '[' + text + ']';
}

std::string points(int earned, int all) {
  return fmt::format("{:>7}", fmt::format("{}/{}", earned, all));
}

std::string remark(const Standing& standing, const LabResult& lab) {
  if (!lab.compile_error.empty()) return coloured(lab.defect(), Colour::Red);
  if (lab.is_finished()) return coloured("done", Colour::Green);
  if (standing.untouched.count(lab.lab_name) != 0) return coloured("not begun", Colour::Faint);
  return "at " + lab.next_failure()->step_to_mend();
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

/// The second score: whether the labs work together.
void print_engine(const Standing& standing) {
  if (!standing.engine_fault.empty()) {
    std::cout << padded("Your engine, assembled", 27) << "not known, because it was not built:\n"
              << indented(standing.engine_fault, 2);
    return;
  }
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
  if (const std::string version = starter_version(project_root()); !version.empty()) {
    std::cout << coloured("Starter version " + version, Colour::Faint) << '\n';
  }
}

/// The next step and the first test that does not pass. @param lines the longest reason to print
void print_next(const Standing& standing, int lines = std::numeric_limits<int>::max()) {
  if (!standing.next) {
    std::cout << fmt::format("\nEvery test passes. To run your engine: ./cs550 lab {} --run\n",
                             lab_number(standing.labs.back().lab_name));
    return;
  }
  const LabResult& lab = standing.labs[*standing.next];
  if (!lab.compile_error.empty()) {
    std::cout << "\nNext: " << coloured(title(lab.lab_name) + ' ' + lab.defect(), Colour::Bold)
              << '\n'
              << first_lines(indented(lab.compile_error, 4), lines);
    return;
  }
  const Verdict failure = *lab.next_failure();
  const std::string handout = lab_of_step(failure.step_to_mend());
  const Step step = handout_step(handout, failure.step_to_mend());
  std::cout << "\nNext: " << coloured(step.tag + ' ' + step.title, Colour::Bold)
            << fmt::format("   (labs/{}/README.md)\n  {}, {} points:\n", handout, failure.test.name,
                           failure.test.points)
            << first_lines(indented(failure.message, 4), lines);
}

/// Every test of the next lab.
void print_tests(const Standing& standing) {
  if (!standing.next) return print_next(standing);
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

/// The next hint for the next step. @return an ExitCode
int print_hint(const Standing& standing) {
  if (!standing.next) {
    print_next(standing);
    return Good;
  }
  const LabResult& lab = standing.labs[*standing.next];
  if (!lab.compile_error.empty()) {
    print_next(standing);
    return Failed;
  }
  return give_hint(*lab.next_failure(), 0);
}

/// Every lab with its points, the milestones and the next step, in 24 lines of 80 columns.
void print_overview(const Standing& standing) {
  constexpr int lines_of_reason = 8;  // so that everything fits into 24 lines
  print_labs(standing);
  print_next(standing, lines_of_reason);
}

/// When each lab file was last saved. Polling is cheap for so few files, and works where file
/// events do not, as on Windows drives under WSL.
std::map<fs::path, fs::file_time_type> times_of_saving() {
  std::map<fs::path, fs::file_time_type> times;
  for (const std::string& name : lab_names()) {
    for (const fs::path& file : lab_files(name)) {
      std::error_code absent;  // for an instant, while an editor replaces it
      times[file] = fs::last_write_time(file, absent);
    }
  }
  return times;
}

void clear_screen() { std::cout << "\033[H\033[2J\033[3J"; }

void answer(char key, const Standing& standing) {
  clear_screen();
  switch (key) {
    case 'h':
      print_hint(standing);
      break;
    case 'n':
      print_next(standing);
      break;
    case 'l':
      print_tests(standing);
      break;
    default:
      print_overview(standing);
  }
  std::cout << coloured("\nh hint   n next step   l list of tests   r run   q quit", Colour::Faint)
            << std::flush;
}

int watch() {
  if (isatty(STDIN_FILENO) == 0 || isatty(STDOUT_FILENO) == 0) {
    print_error("--watch reads keys and redraws the screen: run it in a terminal");
    return Misused;
  }
  const KeyByKey keys;
  auto saved = times_of_saving();
  Standing standing = look_at_labs();
  answer('r', standing);
  while (true) {
    char key = KeyByKey::wait();
    if (key == 'q') break;
    auto now = times_of_saving();
    if (now != saved) key = 'r';
    if (key == 'r') {
      saved = std::move(now);
      standing = look_at_labs();
    }
    if (key != 0) answer(key, standing);
  }
  std::cout << '\n';
  return Good;
}

int run_progress(const ProgressOptions& options) {
  if (options.watch) return watch();
  const Standing standing = look_at_labs();
  if (options.hint) return print_hint(standing);
  if (options.list) {
    print_tests(standing);
  } else if (options.next) {
    print_next(standing);
  } else {
    print_overview(standing);
  }
  return Good;
}

}  // namespace

Action declare_progress(CLI::App& app) {
  const auto options = std::make_shared<ProgressOptions>();
  std::vector<CLI::Option*> views{
      app.add_flag("--watch", options->watch,
                   "repeat after every save; keys: h hint, n next step,\n"
                   "l list of tests, r run, q quit"),
      app.add_flag("--next", options->next,
                   "print the next step and the report of its failing test"),
      app.add_flag("--list", options->list, "list every test of the next lab"),
      app.add_flag("--hint", options->hint, "print the next hint for the next step")};
  for (CLI::Option* view : views) {
    for (CLI::Option* other : views) {
      if (view != other) view->excludes(other);
    }
  }
  return [options] { return run_progress(*options); };
}

}  // namespace cs550::cli
