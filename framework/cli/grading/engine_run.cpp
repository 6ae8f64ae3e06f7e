#include "cli/grading/engine_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "cli/grading/crash_report.hpp"
#include "cli/grading/debugging.hpp"
#include "cli/grading/lab_files.hpp"
#include "cli/system/exit_code.hpp"
#include "cli/system/process.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"
#include "cli/system/watch.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using std::chrono::seconds;

namespace {

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

/// How long the engine may run: 60 s, five times that with sanitizers.
seconds patience(bool sanitized) {
  const char* chosen = std::getenv("CS550_ENGINE_SECONDS");  // for tests and slow machines
  const seconds plain{chosen != nullptr ? std::max(1, std::atoi(chosen)) : 60};
  return sanitized ? 5 * plain : plain;
}

/// How long one step may take, as long as a graded test: an endless loop is found early.
seconds patience_of_a_step(bool sanitized) {
  return std::max(seconds{1}, patience(sanitized) / 12);
}

struct EngineEnding {
  Ending ending;
  std::string in_words;  ///< meaningful if it did not end by itself
  std::string calls;     ///< where a sanitized one was when it was stopped
};

/// Runs a program until it ends or takes too long, and prints its output, or in short what the
/// sanitizers report.
EngineEnding run_limited(std::vector<std::string> command, bool sanitized) {
  const fs::path output = draft_result("engine_run");
  if (sanitized) configure_sanitizers();
  const fs::path pulse = draft_result("engine_pulse");
  command.insert(command.end(), {"--pulse", pulse});
  Watch steps(pulse, patience_of_a_step(sanitized));
  bool without_a_step = false;
  const auto start = Clock::now();
  StatusLine status;
  const auto is_stuck = [&] {
    const auto passed = Clock::now() - start;
    status.show([&] {
      return fmt::format("Running your engine: {} s of at most {} s, or {} s without a step",
                         std::chrono::duration_cast<seconds>(passed).count(),
                         patience(sanitized).count(), patience_of_a_step(sanitized).count());
    });
    without_a_step = steps.is_stuck();
    return without_a_step || passed > patience(sanitized);
  };
  const Ending ending = run(command, {{}, output, is_stuck, students_limits(sanitized), SIGABRT});
  status.clear();
  const std::string printed = read_output(output, ending);
  fs::remove(output);
  fs::remove(pulse);
  const std::string report = sanitized ? crash_report(printed) : "";
  const std::string calls = ending.stopped ? calls_in(report) : "";
  if (calls.empty()) {
    std::cout << indented(report.empty() ? printed : "not reached: " + report, 0) << std::flush;
  }
  if (!ending.stopped || !without_a_step) return {ending, ending.in_words(), calls};
  return {ending,
          fmt::format("stopped: it made no step for {} s (an endless loop?)",
                      patience_of_a_step(sanitized).count()),
          calls};
}

/// How the engine ended if not by itself, and what to try.
void print_ending(int lab, const EngineEnding& how) {
  const Ending& ending = how.ending;
  if (ending.signal == 0 && !ending.stopped) return;
  std::cout << fmt::format("\nnot reached: {}\n", how.in_words);
  if (!how.calls.empty()) {
    std::cout << indented(how.calls, 0);
    return;
  }
  const std::string advice = ending.printed_too_much()
                                 ? fmt::format("--debug  {}", how_to_find_a_loop)
                                 : "--asan  which prints the line";
  std::cout << fmt::format("try  ./cs550 lab {} --run {}\n", lab, advice);
}

}  // namespace

int run_engine(int lab, Grading grading) {
  const bool sanitized = grading == Grading::Sanitized;
  const std::string program = "milestones_" + variant(sanitized ? grading : Grading::Plain);
  if (!build("student", program)) return Failed;
  std::cout << coloured(lab == 1 ? "Your own engine, lab 1"
                                 : fmt::format("Your own engine, labs 1 to {}", lab),
                        Colour::Bold)
            << "\n\n"
            << std::flush;
  const std::vector<std::string> arguments{"--lab", std::to_string(lab)};
  const std::vector<std::string> command{built_program("student", program), arguments[0],
                                         arguments[1]};
  const EngineEnding how = run_limited(command, sanitized);
  if (how.ending.good()) {
    if (grading == Grading::Debugged) std::cout << "There is nothing to debug.\n";
    return Good;
  }
  print_ending(lab, how);
  offer_solutions(lab);
  if (grading != Grading::Debugged) return Failed;
  return run_in_gdb("milestones_" + variant(Grading::Debugged), arguments, "your engine");
}

}  // namespace cs550::cli
