/// What the command line reads from the log of a build.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cli/scratch_project.hpp"
#include "cli/system/build_log.hpp"

namespace {

namespace fs = std::filesystem;
using namespace cs550::cli;

class BuildLog : public ScratchProject {
 protected:
  BuildLog() { fs::create_directories(root / "build"); }
  void write(const std::string& text) const { std::ofstream(root / "build/student.log") << text; }
};

TEST_F(BuildLog, WarningsAreOfTheStudentsOwnFilesAndEachIsNamedOnce) {
  const std::string warning = "labs/lab3_hill_climbing/hill_climbing.cpp:7:3: warning: unused 'x'";
  write("[1/3] Building CXX object labs.o\n" + root.string() + '/' + warning +
        "\n    7 |   int x;\n[2/3] Building CXX object given.o\n" +
        "../../framework/engine/world/step.cpp:9:1: warning: given code\n" +
        "../../.starters/lab3_hill_climbing/hill_climbing.cpp:7:3: warning: the starter\n" +
        "../../" + warning + "\n[3/3] Linking\n");
  EXPECT_EQ(own_warnings(), std::vector<std::string>{warning});
  write("ninja: no work to do.\n");
  EXPECT_TRUE(own_warnings().empty());
}

TEST_F(BuildLog, ThePathOfTheFirstErrorIsRelative) {
  const std::string error = "labs/lab3_hill_climbing/hill_climbing.cpp:7:3: error: expected ';'";
  for (const std::string& start : {root.string() + '/', std::string("../../")}) {
    write("[1/3] Building\nFAILED: lab3.o\nc++ -c lab3.cpp\n" + start + error +
          "\nninja: build stopped: subcommand failed.\n");
    EXPECT_EQ(first_build_error(), error);
  }
}

TEST_F(BuildLog, AnErrorThatStoppedTheBuildComesBeforeThoseOfLabsThatCountAsEmpty) {
  write(
      "[1/3] Building\nlabs/lab4.cpp:1:1: error: tolerated\nFAILED: lab3.o\nc++ -c lab3.cpp\n"
      "labs/lab3.cpp:1:1: error: fatal\n");
  EXPECT_EQ(first_build_error(), "labs/lab3.cpp:1:1: error: fatal");
}

TEST_F(BuildLog, AStepThatWasStoppedDoesNotHaveTheErrorOfALabThatCountsAsEmpty) {
  const std::string report = "cc1plus: out of memory allocating 65536 bytes";
  write("[1/3] Building\nlabs/lab4.cpp:1:1: error: tolerated\nFAILED: lab3.o\nc++ -c lab3.cpp\n" +
        report + "\nninja: build stopped: subcommand failed.\n");
  EXPECT_EQ(first_build_error(), report);
  EXPECT_FALSE(is_students_error(first_build_error()));
}

/// Ninja waits for the steps that are running when one fails.
TEST_F(BuildLog, WhatOtherStepsPrintAfterTheFailedOneIsNotItsError) {
  const std::string report =
      "cc1plus: out of memory allocating 65536 bytes after a total of 0 bytes";
  const std::string failed = "[6/9] Building\nFAILED: lab3.o\nc++ -c lab3.cpp\n" + report + '\n';
  const std::string stopped = "ninja: build stopped: subcommand failed.\n";
  const std::string next = "[7/9] Building CXX object lab4.o\n";
  const std::string of_lab_4 =
      "../../labs/lab4_separating_axis/separating_axis.cpp:3:1: error: expected ';'\n";
  for (const std::string& others :
       {next, next + of_lab_4, next + "FAILED: lab4.o\nc++ -c\n" + of_lab_4}) {
    write(failed + others + stopped);
    EXPECT_EQ(first_build_error(), report) << others;
    EXPECT_FALSE(is_students_error(first_build_error())) << others;
  }
}

TEST_F(BuildLog, ATemplateOfAnotherStepDoesNotMakeAKilledCompilerTheStudents) {
  const std::string in_template =
      "/usr/include/eigen3/Eigen/src/Core/Product.h:7:3: error: static assertion failed\n"
      "../../labs/lab5_clipping/clipping.cpp:7:3:   required from here\n";
  const std::string in_warning =
      "../../labs/lab4_separating_axis/separating_axis.cpp:7:3:   required from here\n"
      "/usr/include/eigen3/Eigen/src/Core/Product.h:7:3: warning: unused 'x'\n";
  const std::string killed = "c++: fatal error: Killed signal terminated program cc1plus";
  write("[1/3] Building\n" + in_template + "[2/3] Building\nFAILED: lab4.o\nc++ -c\n" + in_warning +
        killed + "\nninja: build stopped: subcommand failed.\n");
  EXPECT_EQ(first_build_error(), killed);
  EXPECT_FALSE(is_students_error(killed));
}

TEST_F(BuildLog, AStepThatPrintsNothingHasNoOthersError) {
  write(
      "[1/3] Building\nlabs/lab4.cpp:1:1: error: tolerated\n[2/3] Building\nFAILED: lab3.o\n"
      "c++ -c lab3.cpp\nninja: build stopped: subcommand failed.\n");
  EXPECT_EQ(first_build_error(), "the build failed");
  EXPECT_FALSE(is_students_error(first_build_error()));
}

TEST_F(BuildLog, TheReasonOfALinkThatFailedIsTheLinkers) {
  const std::string failed = "[1/3] Linking\nFAILED: lab3_student\nc++ -o lab3_student\n";
  for (const char* last : {"collect2: error: ld returned 1 exit status\n",
                           "clang: error: linker command failed with exit code 1 (use -v to see "
                           "invocation)\n"}) {
    for (const std::string reason :
         {"ld: final link failed: No space left on device",
          "ld: lab3_test.cpp:7: undefined reference to `cs550::hill_climb'"}) {
      write(failed + reason + '\n' + last);
      EXPECT_EQ(first_build_error(), reason);
    }
  }
}

/// A template's error is in its header, and the linker's in no file.
TEST_F(BuildLog, AnErrorOutsideOfTheLabsFilesMayBeTheStudents) {
  const std::string failed = "[1/3] Building\nFAILED: lab3_hill_climbing.cpp.o\nc++ -c\n";
  for (const char* report :
       {"../../labs/lab3_hill_climbing/hill_climbing.cpp:7:3: error: expected ';'\n",
        "/usr/include/eigen3/Eigen/src/Core/Product.h:7:3: error: static assertion failed\n"
        "../../labs/lab3_hill_climbing/hill_climbing.cpp:7:3:   required from here\n",
        "ld: lab3_test.cpp:7: undefined reference to `cs550::hill_climb'\n"
        "collect2: error: ld returned 1 exit status\n"}) {
    write(failed + report);
    EXPECT_TRUE(is_students_error(first_build_error())) << report;
  }
}

TEST_F(BuildLog, AnErrorOfTheMachineIsNotTheStudents) {
  for (const char* report :
       {"c++: fatal error: Killed signal terminated program cc1plus\n",
        "collect2: fatal error: ld terminated with signal 9 [Killed]\n",
        "ld: final link failed: No space left on device\n"
        "collect2: error: ld returned 1 exit status\n",
        "framework/include/cs550/math.hpp:5:10: fatal error: Eigen/Core: No "
        "such file or directory\n",
        "cc1plus: out of memory allocating 65536 bytes\n",
        "../../labs/lab3_hill_climbing/hill_climbing.cpp:7:3: warning: unused 'x'\n",
        "c++: fatal error: Terminated signal terminated program cc1plus\n",
        "ccache: error: Failed to create temporary file for x: Disk quota "
        "exceeded\n",
        "../../labs/lab3_hill_climbing/hill_climbing.cpp:60:1: fatal error: "
        "error writing to /tmp/ccX.s: No space left on device\n",
        "ninja: error: 'a.cpp', needed by 'a.o'\n"}) {
    write(std::string("[1/3] Building\nFAILED: lab3.o\nc++ -c\n") + report);
    EXPECT_FALSE(is_students_error(first_build_error())) << report;
  }
}

TEST_F(BuildLog, TheLastCounterIsTheProgress) {
  EXPECT_EQ(build_progress(), "");
  write("[0/2] Re-checking globbed directories...\n");
  EXPECT_EQ(build_progress(), "");
  write("[0/2] Re-checking\n[11/65] Building a.o\na warning\n[12/65] Building b.o\nhalf a li");
  EXPECT_EQ(build_progress(), "[12/65]");
}

}  // namespace
