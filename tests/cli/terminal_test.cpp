/// Text in a terminal of 80 columns.
#include <gtest/gtest.h>

#include "cli/system/terminal.hpp"

namespace {

using cs550::cli::indented;

TEST(Terminal, ALongLineGoesOnBelowItsText) {
  EXPECT_EQ(
      indented("  likely    a climb looks at the neighbours of where it stands and at nothing "
               "else, ever",
               6),
      "        likely    a climb looks at the neighbours of where it stands and at\n"
      "                  nothing else, ever\n");
  EXPECT_EQ(indented(std::string(75, 'x') + " end", 2), "  " + std::string(75, 'x') + "\n  end\n");
}

TEST(Terminal, AWordThatDoesNotFitIsKeptWhole) {
  const std::string path = "  picture   build/results/pictures/" + std::string(60, 'x') + ".svg";
  EXPECT_EQ(indented(path, 6), std::string(6, ' ') + path + '\n');
}

TEST(Terminal, EmptyAndBlankLinesStay) {
  EXPECT_EQ(indented("one\n\n   \ntwo", 2), "  one\n\n     \n  two\n");
}

}  // namespace
