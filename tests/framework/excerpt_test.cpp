#include "cs550/excerpt.hpp"

#include <gtest/gtest.h>

namespace cs550 {
namespace {

TEST(Excerpt, OfAShortTextIsTheText) {
  EXPECT_EQ(excerpt(""), "");
  EXPECT_EQ(excerpt(std::string(60, 'a')), std::string(60, 'a'));
  EXPECT_EQ(excerpt("größer"), "größer");
}

TEST(Excerpt, OfALongTextHasItsBeginning) {
  EXPECT_EQ(excerpt(std::string(5000, 'a')), std::string(57, 'a') + "...");
  EXPECT_EQ(excerpt("abcdefgh", 6), "abc...");
  EXPECT_EQ(excerpt("abcd", 2), "...");
}

TEST(Excerpt, CutsNoCharacterInTwo) {
  EXPECT_EQ(excerpt("aöööö", 7), "aö...") << "ö has two bytes";
  EXPECT_EQ(excerpt("€€€€", 6), "€...") << "€ has three bytes";
}

TEST(Excerpt, HasNothingThatATerminalObeys) {
  EXPECT_EQ(excerpt("\033[2Jtitle\n\x7f"), "?[2Jtitle??");
  EXPECT_EQ(excerpt("a\xc2\x9b"
                    "2Jb\xc2\x80\xc2\x9f"),
            "a?2Jb??")
      << "control characters of two bytes";
  EXPECT_EQ(excerpt("\xc2\xa0\xc2\xb5"), "\xc2\xa0\xc2\xb5") << "no control characters";
  EXPECT_EQ(excerpt("\xc2"), "\xc2");
}

TEST(Excerpt, ShortensTheLongWordsOfAMessage) {
  EXPECT_EQ(with_short_words("cannot write\n  /tmp/x: no space"),
            "cannot write\n  /tmp/x: no space");
  EXPECT_EQ(with_short_words("no " + std::string(5000, 'a') + " here"),
            "no " + std::string(297, 'a') + "... here");
}

}  // namespace
}  // namespace cs550
