/// Programs that the command line runs.
#include "cli/system/process.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace {

namespace fs = std::filesystem;

using cs550::cli::output_of;
using cs550::cli::run;

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

}  // namespace
