// ./cs550 lab N: the graded tests of one lab on the student's code, and help with the failing ones.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>

#include "cli/command_line.hpp"
#include "cli/grading/challenge.hpp"
#include "cli/grading/debugging.hpp"
#include "cli/grading/earlier_labs.hpp"
#include "cli/grading/engine_run.hpp"
#include "cli/grading/lab_files.hpp"
#include "cli/grading/lab_report.hpp"
#include "cli/grading/lab_result.hpp"
#include "cli/grading/long_tests.hpp"
#include "cli/grading/memory_signs.hpp"
#include "cli/grading/pictures.hpp"
#include "cli/handout/handout.hpp"
#include "cli/system/build_log.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"
#include "cli/verb.hpp"
#include "cs550/excerpt.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;

namespace {

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

/// A step as the handouts spell it: L6.3 for "6.3" and "l6.3".
std::string step_tag(std::string typed) {
  if (typed.empty()) return typed;
  if (typed.front() == 'l') typed.front() = 'L';
  return typed.front() >= '0' && typed.front() <= '9' ? 'L' + typed : typed;
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
    std::cout << indented(
        fmt::format("{} is {}. There is nothing to debug.", failure->test.name, failure->message),
        0);
    return Failed;
  }
  return run_in_gdb(graded_target(lab, Grading::Debugged),
                    {"--gtest_break_on_failure", "--gtest_filter=*." + failure->test.name},
                    failure->test.name);
}

/// The failures of the last run, if it is still valid and one of these tests failed: `--debug` need not
/// repeat an endless loop.
std::optional<LabResult> known_failures(const std::string& lab_name,
                                        const std::vector<GradedTest>& tests) {
  std::optional<LabResult> result = remembered_result(lab_name);
  if (!result || !result->compile_error.empty()) return std::nullopt;
  std::erase_if(result->verdicts, [&](const Verdict& verdict) {
    return std::none_of(tests.begin(), tests.end(),
                        [&](const GradedTest& test) { return test.name == verdict.test.name; });
  });
  return result->next_failure() ? result : std::nullopt;
}

/// The build that the options ask for.
Grading grading_of(const LabOptions& options) {
  if (options.asan) return Grading::Sanitized;
  return options.debug ? Grading::Debugged : Grading::Plain;
}

/// The compiler's warnings of the student's own files, if something was compiled.
void print_warnings() {
  constexpr std::size_t most = 3;
  const std::vector<std::string> warnings = own_warnings();
  for (std::size_t i = 0; i < std::min(most, warnings.size()); ++i) {
    std::cout << indented(warnings[i], 0);
  }
  if (warnings.size() > most) {
    std::cout << fmt::format("and {} more; build/student.log has all of them\n",
                             warnings.size() - most);
  }
  if (!warnings.empty()) std::cout << '\n';
}

/// Of the failure to mend first, what --asan may explain.
void print_memory_advice(int lab, const LabResult& result) {
  const std::optional<Verdict> failure = result.next_failure();
  if (!failure) return;
  const std::string advice =
      memory_advice(built_program("student", graded_target(lab, Grading::Plain)), lab, *failure,
                    students_limits(false));
  if (!advice.empty()) std::cout << '\n' << indented(advice, 0);
}

int grade_lab(const LabOptions& options, const std::vector<GradedTest>& tests) {
  if (options.debug) {
    if (const auto known = known_failures(options.name, tests)) {
      return debug_first_failure(options.lab, *known);
    }
  }
  const Grading grading = options.asan ? Grading::Sanitized : Grading::Plain;
  const bool is_whole_lab = options.step.empty();
  const bool is_remembered = is_whole_lab && !options.asan;
  LabResult result = result_of_starter(options.name);
  if (const std::string fault = fault_of_absent_code(options.name); !fault.empty()) {
    print_error(fault);
    result.compile_error = fault;
    if (is_remembered) remember(result);
    return Failed;
  }
  if (!build("student", graded_target(options.lab, grading))) {
    result.compile_error = first_build_error();
    if (is_remembered && is_students_error(result.compile_error)) remember(result);
    return Failed;
  }

  print_warnings();
  std::cout << coloured(title(options.name), Colour::Bold) << "\n\n" << std::flush;
  result.verdicts.clear();
  // Counts of the same code stay valid.
  if (const auto former = remembered_result(options.name)) result.challenge = former->challenge;
  LabReport report(options.all, known_causes(options.name));
  const bool has_long_tests = !only(tests, true).empty();
  std::vector<EarlierFault> earlier;
  const Arrived print = [&](std::vector<Verdict> verdicts) {
    if (earlier.empty()) earlier = warn_of_earlier_labs(options.name, verdicts);
    explain_blocked_tests(verdicts, earlier);
    report.print(verdicts);
    if (has_long_tests && !verdicts.front().test.is_long) {
      std::cout << coloured("  The long tests:", Colour::Faint) << std::endl;
    }
    result.verdicts.insert(result.verdicts.end(), verdicts.begin(), verdicts.end());
  };
  grade(options.lab, grading, tests, print, options.all);
  report.print_total(is_whole_lab ? points_graded_elsewhere(options.name) : 0,
                     earlier.empty() ? "" : earlier.front().in_words());
  if (is_remembered) remember(result);
  if (grading == Grading::Plain) print_memory_advice(options.lab, result);
  finish_pictures(options.lab, result.verdicts);

  if (options.debug) return debug_first_failure(options.lab, result);
  return result.next_failure() ? Failed : Good;
}

/// A hint for the given step, else for the first one with a failing test: in an earlier lab, if that one
/// fails by itself.
int run_hint(const LabOptions& options) {
  if (!options.step.empty()) return show_hint(options.name, options.step, options.hint);
  const LabResult result = result_of(options.name);
  if (!result.compile_error.empty()) {
    std::cerr << title(options.name) << ' ' << result.defect() << ":\n"
              << indented(result.compile_error, 2);
    return Failed;
  }
  const std::vector<EarlierFault> earlier = warn_of_earlier_labs(options.name, result.verdicts);
  if (!earlier.empty()) {
    const std::string& step = earlier.front().step;
    return step.empty() ? Failed : show_hint(lab_of_step(step), step, options.hint);
  }
  if (const std::optional<Verdict> failure = result.next_failure()) {
    return give_hint(*failure, options.hint);
  }
  std::cout << "Every test of lab " << options.lab << " passes: no hint is needed.\n";
  return Good;
}

void print_backups(const std::vector<fs::path>& backups) {
  if (backups.empty()) return;
  std::cout << "Your files were kept as\n";
  for (const fs::path& backup : backups) {
    std::cout << "  " << backup.lexically_relative(project_root()).string() << '\n';
  }
}

/// @param backups nothing if the files were that already
void print_replacement(const LabOptions& options, const char* by,
                       const std::optional<std::vector<fs::path>>& backups) {
  std::cout << fmt::format("labs/{} is {}", options.name, by);
  if (!backups) {
    std::cout << " already: nothing was changed.\n";
    return;
  }
  std::cout << " now.\n";
  print_backups(*backups);
}

int reset_lab(const LabOptions& options) {
  print_replacement(options, "the starter", reset_to_starter(options.name));
  return Good;
}

int copy_solution(const LabOptions& options) {
  const std::optional<std::vector<fs::path>> backups = use_solution(options.name);
  print_replacement(options, "the solution", backups);
  if (backups) {
    std::cout << fmt::format("./cs550 lab {} --reset restores the starter.\n", options.lab);
  }
  return Good;
}

/// Counts beside the reference's, once every test passes.
int run_challenge(const LabOptions& options) {
  if (!remembered_result(options.name)) show_status("Grading " + title(options.name) + " ...");
  LabResult result = result_of(options.name);
  show_status("");
  if (!result.is_finished()) {
    std::cout << fmt::format(
        "Lab {} has {} of {} points. Its challenge begins when every test passes:\n"
        "  ./cs550 lab {}\n",
        options.lab, result.earned(), result.points(), options.lab);
    return Failed;
  }
  // Another command may have built other code since.
  if (!build("student", graded_target(options.lab, Grading::Plain))) return Failed;
  std::cout << coloured(title(options.name), Colour::Bold) << ", the challenge (no points)\n\n"
            << std::flush;
  result.challenge = students_counts(options.lab);
  print_counts(result.challenge, reference_counts(options.name));
  remember(result);
  return Good;
}

/// Labs 1 to N together. In place of a lab without code the build would take the reference.
int run_labs_together(const LabOptions& options) {
  for (const std::string& name : lab_names()) {
    const std::string fault = lab_number(name) <= options.lab ? fault_of_absent_code(name) : "";
    if (fault.empty()) continue;
    print_error(fault);
    return Failed;
  }
  return run_engine(options.lab, grading_of(options));
}

int run_lab(LabOptions options) {
  options.name = lab_name(options.lab);
  options.step = step_tag(options.step);
  if (options.reset) return reset_lab(options);
  if (options.use_solution) return copy_solution(options);
  if (options.run) return run_labs_together(options);
  if (options.challenge) return run_challenge(options);
  const std::vector<GradedTest> all = graded_tests(options.name);
  const std::vector<GradedTest> tests = of_step(all, options.step);
  if (tests.empty()) {
    print_error(fmt::format("lab {} has no step {}. Its steps: {}", options.lab,
                            excerpt(options.step), steps_of(all)));
    return Misused;
  }
  return options.wants_hint ? run_hint(options) : grade_lab(options, tests);
}

}  // namespace

Action declare_lab(CLI::App& app) {
  const auto options = std::make_shared<LabOptions>();
  app.add_option("N", options->lab, "number of the lab (3, lab3 or L3)")
      ->required()
      ->transform(plain_lab_number)
      ->check(fault_of_lab_number);
  auto* step =
      app.add_option("--step", options->step, "run the tests of one step only: L3.2 or 3.2")
          ->option_text("STEP");
  auto* hint = app.add_option("--hint", options->hint,
                              "print the next hint for the first failing step,\n"
                              "or hint 1, 2 or 3")
                   ->expected(0, 1)
                   ->check(CLI::Range(1, 3))
                   ->option_text("[NUMBER]");
  auto* all = app.add_flag("--all", options->all,
                           "print the reports of all failing tests, not only those\n"
                           "of the first failing step, and run every long test");
  auto* asan = app.add_flag("--asan", options->asan,
                            "run the tests, or the scenes of --run, with checks for\n"
                            "memory errors and undefined behaviour; prints where an\n"
                            "endless loop is");
  auto* debug = app.add_flag("--debug", options->debug,
                             "run the tests, or the scenes of --run, then open gdb\n"
                             "where the first one fails");
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
  for (CLI::Option* other : {step, all}) run->excludes(other);
  return [options, hint] {
    options->wants_hint = hint->count() > 0;
    return run_lab(*options);
  };
}

}  // namespace cs550::cli
