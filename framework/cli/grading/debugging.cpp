#include "cli/grading/debugging.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>

#include "cli/system/exit_code.hpp"
#include "cli/system/process.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"

namespace cs550::cli {

namespace {

constexpr std::chrono::seconds gdb_patience{
    60};  ///< without a terminal, where nobody presses Ctrl-C

}  // namespace

int run_in_gdb(const std::string& target, const std::vector<std::string>& arguments,
               const std::string& what) {
  if (!run({project_root() / "cs550", "doctor", "--install", "debug"}).good()) return Failed;
  if (!build("student", target)) return Failed;
  std::vector<std::string> gdb{
      "gdb", "-q", "-iex", "set debuginfod enabled off", "-x", "framework/cli/debug.gdb"};
  const bool can_ask = isatty(STDIN_FILENO) != 0;
  if (!can_ask) gdb.insert(gdb.end(), {"-batch", "-ex", "backtrace"});
  gdb.insert(gdb.end(), {"--args", built_program("student", target)});
  gdb.insert(gdb.end(), arguments.begin(), arguments.end());
  std::cout << indented(
                   fmt::format(
                       "gdb runs {} up to its failure. If it does not end, Ctrl-C shows where it "
                       "loops. To step through your own function: "
                       "`break` and its name, `run`, then `next` or `step`. `quit` leaves gdb.",
                       what),
                   0)
            << std::flush;
  std::filesystem::current_path(project_root());
  if (can_ask) become(gdb);
  const auto start = std::chrono::steady_clock::now();
  const auto is_stuck = [&] { return std::chrono::steady_clock::now() - start > gdb_patience; };
  if (run(gdb, {{}, {}, is_stuck, {}, SIGABRT}).stopped) {
    std::cout << "It does not end. In a terminal, Ctrl-C shows where it loops.\n";
  }
  return Failed;
}

}  // namespace cs550::cli
