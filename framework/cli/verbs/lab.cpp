// ./cs550 lab N: the graded tests of one lab on the student's code, and help with the failing ones.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>

#include "cli/grading/challenge.hpp"
#include "cli/grading/earlier_labs.hpp"
#include "cli/grading/lab_files.hpp"
#include "cli/grading/lab_report.hpp"
#include "cli/grading/lab_result.hpp"
#include "cli/grading/pictures.hpp"
#include "cli/handout/handout.hpp"
#include "cli/system/process.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"
#include "cli/verb.hpp"
#include "cs550/excerpt.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds gdb_patience{
    60};  ///< without a terminal, where nobody presses Ctrl-C

struct LabOptions {
  int lab = 0;
  std::string name;  ///< of the lab's folders
  std::string step;
  bool wants_hint = false;
  int hint = 0;  ///< 0: the next one
  bool asan = false;
  bool debug = false;
  bool reset = false;
  bool use_solution = false;
  bool challenge = false;
  bool run = false;
  bool all = false;  ///< print every report
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

/// The first test that did not pass, in the debugger. Without a terminal it only prints the calls
/// that led to the failure.
int debug_first_failure(int lab, const LabResult& result) {
  const std::optional<Verdict> failure = result.next_failure();
  if (!failure) {
    std::cout << "Every test passes: there is nothing to debug.\n";
    return Good;
  }
  if (failure->kind == Verdict::Kind::Blocked) {
    std::cout << fmt::format("{} needs {}, which is not written yet: there is nothing to debug.\n",
                             failure->test.name, failure->blocked_by);
    return Failed;
  }
  if (!run({project_root() / "cs550", "doctor", "--install", "debug"}).good()) return Failed;
  const std::string target = graded_target(lab, Grading::Debugged);
  if (!build("student", target)) return Failed;
  std::vector<std::string> gdb{
      "gdb", "-q", "-iex", "set debuginfod enabled off", "-x", "framework/cli/debug.gdb"};
  const bool can_ask = isatty(STDIN_FILENO) != 0;
  if (!can_ask) gdb.insert(gdb.end(), {"-batch", "-ex", "backtrace"});
  gdb.insert(gdb.end(), {"--args", built_program("student", target), "--gtest_break_on_failure",
                         "--gtest_filter=*." + failure->test.name});
  std::cout << "gdb runs " << failure->test.name
            << " up to its failure. To step through your own function: `break`\n"
               "and its name, `run`, then `next` or `step`. `quit` leaves gdb.\n"
            << std::flush;
  fs::current_path(project_root());
  if (can_ask) become(gdb);
  const auto start = std::chrono::steady_clock::now();
  const auto is_stuck = [&] { return std::chrono::steady_clock::now() - start > gdb_patience; };
  if (run(gdb, {{}, {}, is_stuck}).stopped) {
    std::cout << "The test does not end. In a terminal, Ctrl-C shows where it loops.\n";
  }
  return Failed;
}

bool any_failed(const std::vector<Verdict>& verdicts) {
  return std::any_of(verdicts.begin(), verdicts.end(),
                     [](const Verdict& verdict) { return verdict.kind == Verdict::Kind::Failed; });
}

int grade_lab(const LabOptions& options, const std::vector<GradedTest>& tests) {
  const Grading grading = options.asan ? Grading::Sanitized : Grading::Plain;
  const bool is_whole_lab = options.step.empty();
  const bool is_remembered = is_whole_lab && !options.asan;
  if (!build("student", graded_target(options.lab, grading))) {
    if (is_remembered) remember(result_of_compile_error(options.name, first_build_error()));
    return Failed;
  }

  std::cout << coloured(title(options.name), Colour::Bold) << "\n\n" << std::flush;
  LabResult result = result_of_starter(options.name);
  result.verdicts.clear();
  LabReport report(options.all, known_causes(options.name));
  for (const bool is_long : {false, true}) {
    const std::vector<GradedTest> chosen = only(tests, is_long);
    if (chosen.empty()) continue;
    if (is_long) std::cout << coloured("  The long tests:", Colour::Faint) << std::endl;
    const Arrived print = [&](const std::vector<Verdict>& verdicts) {
      if (any_failed(verdicts) && !any_failed(result.verdicts)) {
        warn_of_earlier_labs(options.name, verdicts);
      }
      report.print(verdicts);
      result.verdicts.insert(result.verdicts.end(), verdicts.begin(), verdicts.end());
    };
    if (is_long) {
      grade(options.lab, grading, chosen, print);  // each result when it comes
    } else {
      print(grade(options.lab, grading, chosen));
    }
  }
  report.print_total(is_whole_lab ? points_graded_elsewhere(options.name) : 0);
  if (is_remembered) remember(result);
  finish_pictures(options.lab, result.verdicts);

  if (options.debug) return debug_first_failure(options.lab, result);
  return result.next_failure() ? Failed : Good;
}

/// A hint for the given step, else for the first one with a failing test.
int run_hint(const LabOptions& options) {
  if (!options.step.empty()) return show_hint(options.name, options.step, options.hint);
  const LabResult result = result_of(options.name);
  if (!result.compile_error.empty()) {
    std::cerr << title(options.name) << " does not compile:\n" << indented(result.compile_error, 2);
    return Failed;
  }
  if (const std::optional<Verdict> failure = result.next_failure()) {
    return give_hint(*failure, options.hint);
  }
  std::cout << "Every test of lab " << options.lab << " passes: no hint is needed.\n";
  return Good;
}

void print_backups(const std::vector<fs::path>& backups) {
  std::cout << "Your files were kept as\n";
  for (const fs::path& backup : backups) {
    std::cout << "  " << fs::relative(backup, project_root()).string() << '\n';
  }
}

int reset_lab(const LabOptions& options) {
  const std::vector<fs::path> backups = reset_to_starter(options.name);
  if (backups.empty()) {
    std::cout << "labs/" << options.name << " is the starter already: nothing was changed.\n";
    return Good;
  }
  std::cout << "labs/" << options.name << " is the starter again. ";
  print_backups(backups);
  return Good;
}

int copy_solution(const LabOptions& options) {
  const std::optional<std::vector<fs::path>> backups = use_solution(options.name);
  if (!backups) {
    std::cout << "labs/" << options.name << " is the solution already: nothing was changed.\n";
    return Good;
  }
  std::cout << "labs/" << options.name << " is now the solution. ";
  print_backups(*backups);
  std::cout << fmt::format("./cs550 lab {} --reset restores the starter.\n", options.lab);
  return Good;
}

/// For each earlier lab that is not finished and has a solution: how to go on without it.
void offer_solutions(int lab) {
  for (const std::string& earlier : lab_names()) {
    const int number = lab_number(earlier);
    if (number >= lab || !has_reference(earlier)) continue;
    if (!is_untouched(earlier) && result_of(earlier).is_finished()) continue;
    std::cout << fmt::format(
        "\nLab {0} is not finished, and its solution is in this copy. Your engine can use\n"
        "it, and your own files are kept:  ./cs550 lab {0} --use-solution\n",
        number);
  }
}

/// Compares the engine made of the student's labs with the recorded reference.
int run_engine(const LabOptions& options) {
  if (!build("student", "milestones_student")) return Failed;
  std::cout << coloured("Your own engine, labs 1 to " + std::to_string(options.lab), Colour::Bold)
            << "\n\n"
            << std::flush;
  const Ending ending =
      run({built_program("student", "milestones_student"), "--lab", std::to_string(options.lab)});
  if (ending.signal != 0) std::cout << "\nnot reached: " << ending.in_words() << '\n';
  if (!ending.good()) offer_solutions(options.lab);
  return ending.good() ? Good : Failed;
}

/// Counts beside the reference's, once every test passes.
int run_challenge(const LabOptions& options) {
  show_status("Grading " + title(options.name) + " ...");
  LabResult result = result_of(options.name);
  show_status("");
  if (!result.is_finished()) {
    std::cout << fmt::format(
        "Lab {} has {} of {} points. Its challenge begins when every test passes:\n"
        "  ./cs550 lab {}\n",
        options.lab, result.earned(), result.points(), options.lab);
    return Failed;
  }
  std::cout << coloured(title(options.name), Colour::Bold) << ", the challenge (no points)\n\n"
            << std::flush;
  result.challenge = students_counts(options.lab);
  print_counts(result.challenge, reference_counts(options.name));
  remember(result);
  return Good;
}

int run_lab(LabOptions options) {
  options.name = lab_name(options.lab);
  if (options.reset) return reset_lab(options);
  if (options.use_solution) return copy_solution(options);
  if (options.run) return run_engine(options);
  if (options.challenge) return run_challenge(options);
  const std::vector<GradedTest> all = graded_tests(options.name);
  const std::vector<GradedTest> tests = of_step(all, options.step);
  if (tests.empty()) {
    std::cerr << "cs550: lab " << options.lab << " has no step " << excerpt(options.step)
              << ". Its steps: " << steps_of(all) << '\n';
    return Misused;
  }
  return options.wants_hint ? run_hint(options) : grade_lab(options, tests);
}

}  // namespace

Action declare_lab(CLI::App& app) {
  const auto options = std::make_shared<LabOptions>();
  app.add_option("N", options->lab, "number of the lab")->required()->check(fault_of_lab_number);
  auto* step = app.add_option("--step", options->step, "run the tests of one step only: L3.2")
                   ->option_text("STEP");
  auto* hint = app.add_option("--hint", options->hint,
                              "print the next hint for the first failing step,\n"
                              "or hint 1, 2 or 3")
                   ->expected(0, 1)
                   ->check(CLI::Range(1, 3))
                   ->option_text("[NUMBER]");
  auto* all = app.add_flag("--all", options->all,
                           "print the reports of all failing tests, not only those\n"
                           "of the first failing step");
  auto* asan = app.add_flag("--asan", options->asan,
                            "run the tests with checks for memory errors and\n"
                            "undefined behaviour");
  auto* debug = app.add_flag("--debug", options->debug,
                             "run the tests, then open gdb where the first one fails");
  auto* reset = app.add_flag("--reset", options->reset,
                             "restore the starter; your files are kept as .bak-1, ...");
  auto* run = app.add_flag("--run", options->run,
                           "run the lab's scenes in your own engine and compare\n"
                           "them with the recorded reference");
  auto* use_solution = app.add_flag("--use-solution", options->use_solution,
                                    "replace your files by the lab's solution if it has been\n"
                                    "released; your files are kept as .bak-1, ...");
  auto* challenge = app.add_flag("--challenge", options->challenge,
                                 "once every test passes: count how much work your code\n"
                                 "does, beside the reference (no points)");
  debug->excludes(asan);
  for (CLI::Option* other : {all, asan, debug, reset, run, use_solution}) hint->excludes(other);
  for (CLI::Option* other : {step, all, asan, debug, run, use_solution}) reset->excludes(other);
  for (CLI::Option* other : {step, all, asan, debug, run}) use_solution->excludes(other);
  for (CLI::Option* other : {step, hint, all, asan, debug, reset, run, use_solution}) {
    challenge->excludes(other);
  }
  for (CLI::Option* other : {step, all, asan, debug}) run->excludes(other);
  return [options, hint] {
    options->wants_hint = hint->count() > 0;
    return run_lab(*options);
  };
}

}  // namespace cs550::cli
