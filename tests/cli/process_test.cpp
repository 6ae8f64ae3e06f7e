/// Programs that the command line runs.
#include "cli/system/process.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

#include "helpers/scratch_folder.hpp"

namespace {

namespace fs = std::filesystem;

using cs550::cli::Ending;
using cs550::cli::output_of;
using cs550::cli::read_output;
using cs550::cli::run;
using cs550::cli::students_limits;
using cs550::cli::Surroundings;

TEST(Process, AProgramMayExitWithTheCodeOfOneThatCannotBeStarted) {
  EXPECT_EQ(run({"/bin/sh", "-c", "exit 127"}).exit_code, 127);
  EXPECT_THROW(run({"/nowhere/program"}), std::system_error);
  EXPECT_THROW(run({"no-such-program"}), std::system_error);
}

/// On a shared machine, anybody may have made a file of a name that can be guessed.
TEST(Process, NoFileOfAnotherUserIsInTheWayOfAnOutput) {
  const fs::path file = fs::temp_directory_path() / ("cs550." + std::to_string(getpid()) + ".txt");
  fs::create_directory(file);
  EXPECT_NO_THROW(EXPECT_EQ(output_of({"/bin/sh", "-c", "echo one; echo two >&2"}), "one\ntwo\n"));
  fs::remove(file);
  EXPECT_THROW(output_of({"/bin/sh", "-c", "exit 1"}), std::runtime_error);
}

TEST(Process, AProgramThatPrintsWithoutEndIsStopped) {
  const cs550::test::ScratchFolder folder;
  const fs::path file = folder / "endless_print.txt";
  constexpr std::uint64_t most = 1 << 20;
  Surroundings surroundings;
  surroundings.output = file;
  surroundings.limits.output = most;
  const Ending ending = run({"/bin/sh", "-c", "while :; do echo here; done"}, surroundings);
  EXPECT_EQ(ending.in_words(), "stopped: it printed too much (a loop that prints without end?)");
  EXPECT_LE(fs::file_size(file), most);
  EXPECT_EQ(read_output(file, ending).substr(0, 10), "here\nhere\n");
  EXPECT_LT(read_output(file, ending).size(), 3000U) << "nobody reads a megabyte of one line";
}

/// A sanitizer prints at SIGABRT where the program is. grade_lab removes its temporary files at SIGTERM.
TEST(Process, AStuckProgramIsAskedToEndBeforeItIsKilled) {
  EXPECT_EQ(Surroundings{}.stop_signal, SIGTERM);
  for (const int stop_signal : {SIGTERM, SIGABRT}) {
    const cs550::test::ScratchFolder folder;
    Surroundings surroundings;
    surroundings.output = folder / "last_words.txt";
    surroundings.is_stuck = [&] { return fs::exists(folder / "ready"); };
    surroundings.stop_signal = stop_signal;
    const std::string script = "trap 'echo here; exit 3' " + std::to_string(stop_signal) + "; : >" +
                               (folder / "ready").string() + "; while :; do :; done";
    const Ending ending = run({"/bin/sh", "-c", script}, surroundings);
    EXPECT_TRUE(ending.stopped);
    EXPECT_EQ(ending.exit_code, 3);
    EXPECT_EQ(read_output(surroundings.output, ending), "here\n");
  }
}

TEST(Process, AProgramThatAllocatesWithoutEndFails) {
  Surroundings surroundings;
  surroundings.output = "/dev/null";
  surroundings.limits.memory = std::uint64_t{1} << 28;
  const std::string double_a_text = "text=x; while :; do text=$text$text; done";
  EXPECT_FALSE(run({"/bin/sh", "-c", double_a_text}, surroundings).good());
}

TEST(Process, LimitsHoldForStudentsCodeButNotForTheSanitizersMemory) {
  EXPECT_GT(students_limits(false).memory, 0U);
  EXPECT_EQ(students_limits(true).memory, 0U);
  EXPECT_GT(students_limits(true).output, 0U);
}

}  // namespace
