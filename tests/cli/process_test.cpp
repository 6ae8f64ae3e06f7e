/// Programs that the command line runs.
#include "cli/system/process.hpp"

#include <gtest/gtest.h>

#include <system_error>

namespace {

using cs550::cli::run;

TEST(Process, AProgramMayExitWithTheCodeOfOneThatCannotBeStarted) {
  EXPECT_EQ(run({"/bin/sh", "-c", "exit 127"}).exit_code, 127);
  EXPECT_THROW(run({"/nowhere/program"}), std::system_error);
  EXPECT_THROW(run({"no-such-program"}), std::system_error);
}

}  // namespace
