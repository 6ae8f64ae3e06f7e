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

TEST(Terminal, AWordThatDoesNotFitIsKeptWholeOnALineOfItsOwn) {
  const std::string path = std::string(66, 'x') + ".svg";
  EXPECT_EQ(indented("  picture   " + path + "\n  also      more", 6),
            "        picture\n" + std::string(10, ' ') + path + "\n        also      more\n");
  EXPECT_EQ(
      indented("  picture   " + std::string(90, 'x') + " and more", 6),
      "        picture\n" + std::string(90, 'x') + "\n" + std::string(18, ' ') + "and more\n");
  EXPECT_EQ(indented(std::string(78, 'x'), 6), "  " + std::string(78, 'x') + '\n');
}

TEST(Terminal, EmptyAndBlankLinesStay) {
  EXPECT_EQ(indented("one\n\n   \ntwo", 2), "  one\n\n     \n  two\n");
}

}  // namespace
