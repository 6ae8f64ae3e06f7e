/// The course file: what it means, and what is refused, with an example that works when pasted.
#include "gradebook/course/course_file.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "cli/system/files.hpp"
#include "gradebook/course/course_keys.hpp"
#include "gradebook_test.hpp"

namespace cs550::gradebook {
namespace {

/// The message of the error; empty if the file is accepted.
std::string fault_of(const std::string& text) {
  try {
    course_of(text);
    return {};
  } catch (const CourseError& error) {
    return error.what();
  }
}

/// The indented lines at the end of a message.
std::string example_in(const std::string& message) {
  std::istringstream lines(message);
  std::string example;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("    ")) example += line.substr(4) + '\n';
  }
  return example;
}

TEST(CourseFile, EveryExampleWorksByItself) {
  for (const CourseTable& table : course_tables()) {
    EXPECT_EQ(fault_of(std::string(table.example)), "") << table.example;
    for (const CourseKey& key : table.keys) {
      EXPECT_NE(table.example.find(key.name), std::string_view::npos)
          << table.heading() << " has no example of " << key.name;
    }
  }
}

TEST(CourseFile, RefusesDatesThatCannotBeMeant) {
  const std::string lab =
      "[lab.3]\ndue = 2026-10-12T23:59:00+02:00\nsolution_released = 2026-10-20T08:00:00+02:00\n";
  const auto extension = [](const char* date) {
    return std::string("[[extension]]\nstudent = 'ada'\nlab = 3\nreason = 'r'\ndue = ") + date +
           "\n";
  };
  const std::string good = extension("2026-10-14T23:59:00+02:00");
  EXPECT_EQ(fault_of(lab + good), "");
  EXPECT_NE(fault_of(lab + good + good).find("another one"), std::string::npos);
  std::string capitals = good;
  capitals.replace(capitals.find("'ada'"), 5, "'ADA'");
  EXPECT_NE(fault_of(lab + good + capitals).find("another one"), std::string::npos);
  EXPECT_NE(fault_of(lab + extension("2026-10-01T23:59:00+02:00")).find("before the lab's due"),
            std::string::npos);
  EXPECT_NE(fault_of(lab + extension("2026-11-01T23:59:00+02:00")).find("after solution_released"),
            std::string::npos);
  EXPECT_NE(fault_of("[lab.3]\ndue = 2026-10-12T23:59:00+02:00\n"
                     "solution_released = 2026-10-02T08:00:00+02:00\n")
                .find("before due"),
            std::string::npos);
}

TEST(CourseFile, AllExamplesTogetherAreAFile) {
  std::string all;
  for (const CourseTable& table : course_tables()) all += std::string(table.example) + "\n\n";
  const Course course = course_of(all);
  EXPECT_EQ(course.title, "Rigid bodies, autumn 2026");
  EXPECT_EQ(course.retention_days, 400);
  EXPECT_EQ(course.leaderboard, (std::vector<std::string>{"points", "seconds"}));
  EXPECT_EQ(course.hidden_tests, Visibility::AfterPublished);
  EXPECT_EQ(course.lab(3).weight, 1.5);
  EXPECT_EQ(course.lab(3).points, 100);
  EXPECT_EQ(course.lab(4).points, 60) << "the default";
  // 23:59 two hours east of Greenwich
  using namespace std::chrono;
  EXPECT_EQ(course.lab(3).due, sys_days(2026y / October / 12) + 21h + 59min);
  EXPECT_EQ(course.limits_of(3).wall, 60) << "the lab's own";
  EXPECT_EQ(course.limits_of(4).wall, 300) << "the course's";
  EXPECT_EQ(course.limits_of(4).lab, 600);
  ASSERT_TRUE(course.late);
  EXPECT_EQ(course.late->clock, Clock::File);
  EXPECT_EQ(course.late->most_percent, 50);
  ASSERT_EQ(course.adjustments.size(), 1U);
  EXPECT_EQ(course.adjustments[0].points, 2.5);
  ASSERT_EQ(course.extensions.size(), 1U);
  EXPECT_EQ(course.extensions[0].student, "ada");
  ASSERT_EQ(course.regrades.size(), 1U);
  EXPECT_EQ(course.regrades[0].status, RegradeRequest::Status::Granted);
}

TEST(CourseFile, TheExampleOfTheDocumentationIsComplete) {
  const std::string page = cli::read_text(std::string(CS550_ROOT) + "/docs/instructors.md");
  const std::size_t start = page.find("```toml\n") + 8;
  const std::string example = page.substr(start, page.find("```", start) - start);
  EXPECT_EQ(fault_of(example), "") << example;
  for (const CourseTable& table : course_tables()) {
    for (const CourseKey& key : table.keys) {
      EXPECT_NE(example.find(std::string(key.name) + " = "), std::string::npos)
          << key.name << " of " << table.heading() << " is missing";
    }
  }
}

TEST(CourseFile, AnEmptyFileHasTheDefaults) {
  const Course course = course_of("");
  EXPECT_EQ(course.lab(1).points, 60);
  EXPECT_FALSE(course.late);
  EXPECT_EQ(course.secret, "");
}

struct BadFile {
  const char* text;
  const char* place;  ///< file and line
  const char* expected;
  const char* found;
};

class BadCourseFile : public testing::TestWithParam<BadFile> {};

TEST_P(BadCourseFile, IsRefusedWithAnExampleThatWorks) {
  const std::string message = fault_of(GetParam().text);
  EXPECT_EQ(message.substr(0, message.find(' ')), GetParam().place) << message;
  EXPECT_NE(message.find(GetParam().expected), std::string::npos) << message;
  EXPECT_NE(message.find(GetParam().found), std::string::npos) << message;
  const std::string example = example_in(message);
  EXPECT_NE(example, "") << message;
  EXPECT_EQ(fault_of(example), "") << message;
}

INSTANTIATE_TEST_SUITE_P(
    All, BadCourseFile,
    testing::Values(
        BadFile{"title = 5", "course.toml:1:", "text in quotes", "found 5"},
        BadFile{"\nnickname = 'x'", "course.toml:2:", "title, secret", "no key nickname"},
        BadFile{"[latte]\nclock = 'file'", "course.toml:1:", "[late]", "no key latte"},
        BadFile{"[late]\nclock = 'sun'\npercent_per_day = 1", "course.toml:2:", "\"manifest\"",
                "found 'sun'"},
        BadFile{"[late]\npercent_per_day = 10", "course.toml:1:", "needs the key clock", "one of"},
        BadFile{"[late]\nclock = 'file'\npercent_per_day = 101", "course.toml:3:", "from 0 to 100",
                "101"},
        BadFile{"[late]\nclock = 'file'\npercent_per_day = nan", "course.toml:3:", "from 0 to 100",
                "nan"},
        BadFile{"[lab.3]\npoints = 'many'", "course.toml:2:", "a number from 1", "many"},
        BadFile{"[lab.3]\nwall = 2.5", "course.toml:2:", "a whole number", "2.5"},
        BadFile{"[lab.3]\ndue = 2026-10-12", "course.toml:2:", "with its offset", "2026-10-12"},
        BadFile{"[lab.3]\ndue = 2026-10-12T10:00:00", "course.toml:2:", "with its offset", "found"},
        BadFile{"[lab.3]\nmass = 2", "course.toml:2:", "weight, points", "no key mass"},
        BadFile{"[lab.99]\npoints = 60", "course.toml:1:", "The labs: 1, 2", "no lab 99"},
        BadFile{"[lab.three]\npoints = 60", "course.toml:1:", "The labs: 1, 2", "three"},
        BadFile{"lab = 3", "course.toml:1:", "[lab.N]", "found 3"},
        BadFile{"[limits]\nlab = 0", "course.toml:2:", "from 1 to 3600", "found 0"},
        BadFile{"[limits]\nmemory = 1", "course.toml:2:", "from 256", "found 1"},
        BadFile{"limits = 5", "course.toml:1:", "must be a table", "found 5"},
        BadFile{"leaderboard = ['glory']", "course.toml:1:", "\"points\"", "glory"},
        BadFile{"[visibility]\nhidden_tests = 'maybe'", "course.toml:2:", "after_due_date",
                "maybe"},
        BadFile{"[extension]\nstudent = 'ada'", "course.toml:1:", "[[extension]]", "found a table"},
        BadFile{"[[extension]]\nstudent = 'ada'\nlab = 3", "course.toml:1:", "needs the key due",
                "date and time"},
        BadFile{"[[adjustment]]\nstudent = 'ada'\nlab = 12\npoints = 1\nreason = 'x'",
                "course.toml:1:", "adjustment.lab", "no lab 12"},
        BadFile{"[[regrade]]\nstudent = 'a'\nlab = 3\ntest = 'Lab3.No'\nstatus = 'open'",
                "course.toml:1:", "regrade.test", "no test Lab3.No"},
        BadFile{"title = 'open", "course.toml:1:", "not TOML", "An example"},
        BadFile{"[lab.3]\n[lab.3]\n", "course.toml:2:", "not TOML", "An example"}));

}  // namespace
}  // namespace cs550::gradebook
