// ./cs550 lab N: the graded tests of one lab on the student's code, and what helps to pass them.
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>

#include "hints.hpp"
#include "lab_files.hpp"
#include "lab_report.hpp"
#include "lab_result.hpp"
#include "manifest.hpp"
#include "process.hpp"
#include "project.hpp"
#include "terminal.hpp"
#include "verb.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;

namespace {

struct LabOptions {
  int lab = 0;
  std::string name;  ///< of the lab's folders, found from its number
  std::string step;
  bool wants_hint = false;
  int hint = 0;  ///< 0: the next one
  bool asan = false;
  bool debug = false;
  bool reset = false;
  bool run = false;
};

std::vector<GradedTest> of_step(const std::vector<GradedTest>& tests, const std::string& step) {
  std::vector<GradedTest> chosen;
  std::copy_if(tests.begin(), tests.end(), std::back_inserter(chosen),
               [&](const GradedTest& test) { return step.empty() || test.step == step; });
  return chosen;
}

/// @pre the tests come step by step
std::string steps_of(const std::vector<GradedTest>& tests) {
  std::string list;
  std::string last;
  for (const GradedTest& test : tests) {
    if (test.step != last) list += (list.empty() ? "" : ", ") + test.step;
    last = test.step;
  }
  return list;
}

/// The first test that is not passed, in the debugger. Without a terminal to ask at, the calls that
/// led there.
int debug_first_failure(int lab, const LabResult& result) {
  const std::optional<Verdict> failure = result.next_failure();
  if (!failure) {
    std::cout << "Every test passes: there is nothing to debug.\n";
    return Good;
  }
  if (!run({project_root() / "cs550", "doctor", "--install", "debug"}).good()) return Failed;
  const std::string target = graded_target(lab, Grading::Plain);
  if (!build("debug", target)) return Failed;
  std::vector<std::string> gdb{
      "gdb", "-q", "-iex", "set debuginfod enabled off", "-x", "framework/cli/debug.gdb"};
  const bool can_ask = isatty(STDIN_FILENO) != 0;
  if (!can_ask) gdb.insert(gdb.end(), {"-batch", "-ex", "backtrace"});
  gdb.insert(gdb.end(), {"--args", built_program("debug", target), "--gtest_break_on_failure",
                         "--gtest_filter=*." + failure->test.name});
  std::cout << "gdb runs " << failure->test.name
            << " to where it fails. To go through your own function line by\n"
               "line: `break` and its name, `run`, then `next` or `step`; `quit` ends it.\n"
            << std::flush;
  fs::current_path(project_root());
  if (can_ask) become(gdb);
  run(gdb);
  return Failed;
}

int grade_lab(const LabOptions& options, const std::vector<GradedTest>& tests) {
  const Grading grading = options.asan ? Grading::Sanitized : Grading::Plain;
  LabResult result = result_of_starter(options.name);
  result.verdicts.clear();
  if (!build("student", graded_target(options.lab, grading))) return Failed;

  std::cout << coloured(title(options.name), Colour::Bold) << "\n\n" << std::flush;
  const auto grade_and_print = [&](const std::vector<GradedTest>& chosen) {
    const std::vector<Verdict> verdicts = grade(options.lab, grading, chosen);
    print(verdicts);
    result.verdicts.insert(result.verdicts.end(), verdicts.begin(), verdicts.end());
  };
  grade_and_print(only(tests, false));
  const std::vector<GradedTest> long_tests = only(tests, true);
  if (!long_tests.empty()) {
    std::cout << coloured("  The long tests:", Colour::Faint) << std::endl;
    grade_and_print(long_tests);
  }
  const bool whole_lab = options.step.empty();
  print_total(result.verdicts, whole_lab ? points_graded_elsewhere(options.name) : 0);
  if (whole_lab && !options.asan) remember(result);

  if (options.debug) return debug_first_failure(options.lab, result);
  return result.next_failure() ? Failed : Good;
}

/// A hint for the step that was asked for, else for the first one with a failing test.
int give_hint(const LabOptions& options) {
  if (!options.step.empty()) return show_hint(options.name, options.step, options.hint);
  const LabResult result = result_of(options.name);
  const std::optional<Verdict> failure = result.next_failure();
  if (!failure) {
    std::cout << "Every test of lab " << options.lab << " passes: no hint is needed.\n";
    return Good;
  }
  return show_hint(options.name, failure->test.step, options.hint);
}

int reset_lab(const LabOptions& options) {
  const std::vector<fs::path> backups = reset_to_starter(options.name);
  if (backups.empty()) {
    std::cout << "labs/" << options.name << " is the starter: nothing to do.\n";
    return Good;
  }
  std::cout << "labs/" << options.name << " is the starter again. Your work is in\n";
  for (const fs::path& backup : backups) {
    std::cout << "  " << fs::relative(backup, project_root()).string() << '\n';
  }
  return Good;
}

/// The student's labs, all together, against the recorded reference.
int run_engine(const LabOptions& options) {
  if (!build("student", "milestones_student")) return Failed;
  std::cout << coloured("Your own engine, labs 1 to " + std::to_string(options.lab), Colour::Bold)
            << "\n\n"
            << std::flush;
  const Ending ending =
      run({built_program("student", "milestones_student"), "--lab", std::to_string(options.lab)});
  if (ending.signal != 0) std::cout << "\nnot reached: " << ending.in_words() << '\n';
  return ending.good() ? Good : Failed;
}

int run_lab(LabOptions options) {
  options.name = lab_name(options.lab);
  if (options.reset) return reset_lab(options);
  if (options.run) return run_engine(options);
  const std::vector<GradedTest> all = graded_tests(options.name);
  const std::vector<GradedTest> tests = of_step(all, options.step);
  if (tests.empty()) {
    std::cerr << "cs550: lab " << options.lab << " has no step " << options.step
              << ". Its steps: " << steps_of(all) << '\n';
    return Misused;
  }
  return options.wants_hint ? give_hint(options) : grade_lab(options, tests);
}

}  // namespace

Action declare_lab(CLI::App& app) {
  const auto options = std::make_shared<LabOptions>();
  app.add_option("N", options->lab, "number of the lab")->required()->check(fault_of_lab_number);
  auto* step = app.add_option("--step", options->step, "only the tests of this step, as in L3.2");
  auto* hint = app.add_option("--hint", options->hint,
                              "the next hint for the first failing step, or hint 1, 2 or 3")
                   ->expected(0, 1)
                   ->check(CLI::Range(1, 3));
  auto* asan =
      app.add_flag("--asan", options->asan, "look for memory errors and undefined behaviour");
  auto* debug =
      app.add_flag("--debug", options->debug, "then open gdb where the first failing test fails");
  auto* reset = app.add_flag("--reset", options->reset,
                             "put the starter back; your files are kept beside it as backups");
  auto* run =
      app.add_flag("--run", options->run,
                   "run the lab's scenes in your own engine, and compare with the reference");
  debug->excludes(asan);
  for (CLI::Option* other : {asan, debug, reset, run}) hint->excludes(other);
  for (CLI::Option* other : {step, asan, debug, run}) reset->excludes(other);
  for (CLI::Option* other : {step, asan, debug}) run->excludes(other);
  return [options, hint] {
    options->wants_hint = hint->count() > 0;
    return run_lab(*options);
  };
}

}  // namespace cs550::cli
