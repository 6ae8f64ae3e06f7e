#include "cli/grading/engine_run.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "cli/grading/crash_report.hpp"
#include "cli/grading/debugging.hpp"
#include "cli/grading/lab_files.hpp"
#include "cli/system/exit_code.hpp"
#include "cli/system/files.hpp"
#include "cli/system/process.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;

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

/// Runs a program compiled with the sanitizers. Prints what it prints or, in short, what they report.
Ending run_sanitized(const std::vector<std::string>& command) {
  const fs::path output = project_root() / "build/results/sanitized_run.txt";
  fs::create_directories(output.parent_path());
  ask_sanitizers_for_places();
  show_status("Running your engine ...");
  const Ending ending = run(command, {{}, output});
  show_status("");
  const std::string printed = read_text(output);
  fs::remove(output);
  const std::string report = crash_report(printed);
  std::cout << (report.empty() ? printed : "not reached: " + report) << std::flush;
  return ending;
}

}  // namespace

int run_engine(int lab, Grading grading) {
  const bool sanitized = grading == Grading::Sanitized;
  const std::string program = "milestones_" + variant(sanitized ? grading : Grading::Plain);
  if (!build("student", program)) return Failed;
  std::cout << coloured(fmt::format("Your own engine, labs 1 to {}", lab), Colour::Bold) << "\n\n"
            << std::flush;
  const std::vector<std::string> arguments{"--lab", std::to_string(lab)};
  const std::vector<std::string> command{built_program("student", program), arguments[0],
                                         arguments[1]};
  const Ending ending = sanitized ? run_sanitized(command) : run(command);
  if (ending.good()) return Good;
  if (ending.signal != 0) std::cout << "\nnot reached: " << ending.in_words() << '\n';
  offer_solutions(lab);
  if (grading != Grading::Debugged) return Failed;
  return run_in_gdb("milestones_" + variant(Grading::Debugged), arguments, "your engine");
}

}  // namespace cs550::cli
