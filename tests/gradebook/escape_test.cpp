/// Text that a student wrote, in every format that reports use.
#include "gradebook/text/escape.hpp"

#include <gtest/gtest.h>

namespace cs550::gradebook {
namespace {

TEST(Escape, TerminalSequencesAndControlCharactersAreRemoved) {
  EXPECT_EQ(plain_text("\033[31mred\033[0m"), "red");
  EXPECT_EQ(plain_text("\033]0;title\aafter"), "after");
  EXPECT_EQ(plain_text("\033]8;;http://x\033\\link"), "link");
  EXPECT_EQ(plain_text("unfinished \033["), "unfinished ");
  EXPECT_EQ(plain_text(std::string("a\0b\bc\x7F", 6)), "abc");
  EXPECT_EQ(plain_text("two\nlines\tand a tab"), "two\nlines\tand a tab");
  EXPECT_EQ(plain_text("C1: \xC2\x9B"
                       "31m"),
            "C1: 31m");
  EXPECT_EQ(plain_text("reversed \xE2\x80\xAE"
                       "txet"),
            "reversed txet");
}

TEST(Escape, WhatNoXmlDocumentMayContainIsRemoved) {
  EXPECT_EQ(html("a\xEF\xBF\xBE\xEF\xBF\xBF<b"), "a&lt;b");
}

TEST(Escape, InvalidUtf8IsReplaced) {
  EXPECT_EQ(plain_text("Größe λ 🙂"), "Größe λ 🙂");
  EXPECT_EQ(plain_text("\xFF"), "\xEF\xBF\xBD");
  EXPECT_EQ(plain_text("\xC0\xAF"), "\xEF\xBF\xBD\xEF\xBF\xBD") << "overlong";
  EXPECT_EQ(plain_text("\xED\xA0\x80"), "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD") << "a surrogate";
  EXPECT_EQ(plain_text("cut \xE2\x82"), "cut \xEF\xBF\xBD\xEF\xBF\xBD");
}

TEST(Escape, Html) {
  EXPECT_EQ(html("<script>'a' & \"b\"</script>"),
            "&lt;script&gt;&#39;a&#39; &amp; &quot;b&quot;&lt;/script&gt;");
}

TEST(Escape, CsvFieldsAreNoFormulas) {
  EXPECT_EQ(csv("Ada"), "Ada");
  EXPECT_EQ(csv("=HYPERLINK(\"x\")"), "\"'=HYPERLINK(\"\"x\"\")\"");
  EXPECT_EQ(csv("+1"), "'+1");
  EXPECT_EQ(csv("-1"), "'-1");
  EXPECT_EQ(csv("@x"), "'@x");
  EXPECT_EQ(csv("  =1"), "'  =1");
  EXPECT_EQ(csv("\t=1"), "' =1");
  EXPECT_EQ(csv("a,b"), "\"a,b\"");
  EXPECT_EQ(csv("a\nb"), "a b");
}

TEST(Escape, AWordOfACommandIsOneWord) {
  EXPECT_EQ(in_shell("out/lab3-2.zip"), "out/lab3-2.zip");
  EXPECT_EQ(in_shell("my class"), "'my class'");
  EXPECT_EQ(in_shell("Ada's; $(rm)"), "'Ada'\\''s; $(rm)'");
  EXPECT_EQ(in_shell(""), "''");
}

TEST(Escape, MarkdownHasNoMarkupOfTheStudent) {
  EXPECT_EQ(markdown("**b** <i> [x](y)"), "\\*\\*b\\*\\* \\<i\\> \\[x\\]\\(y\\)");
  EXPECT_EQ(markdown_block("a\n```\nb"), "````text\na\n```\nb\n````\n");
  EXPECT_EQ(markdown_block("`````\n"), "``````text\n`````\n``````\n");
}

TEST(Escape, ShortenedTextEndsWithACharacter) {
  EXPECT_EQ(shortened("abc", 3), "abc");
  EXPECT_EQ(shortened("aλλ", 4), "aλ\n… (cut)");
}

}  // namespace
}  // namespace cs550::gradebook
