/// The guesses of the programs and of the launcher follow the same rules.
#include "cs550/nearest_word.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "cli/system/process.hpp"
#include "helpers/scoped_environment.hpp"

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const fs::path project = fs::path(CS550_TEST_DATA).parent_path().parent_path();

struct Guess {
  std::string typed;
  std::string expected;
  Words words;
};

std::string first_word(const std::string& text) {
  std::string word;
  std::istringstream(text) >> word;
  return word;
}

/// The lines `typed | expected | words` of nearest_words.txt.
std::vector<Guess> guesses() {
  std::vector<Guess> list;
  std::ifstream file(project / "tests/cli/nearest_words.txt");
  for (std::string line; std::getline(file, line);) {
    if (line.front() == '#') continue;
    std::istringstream fields(line);
    std::string typed;
    std::string expected;
    std::getline(fields, typed, '|');
    std::getline(fields, expected, '|');
    Guess& guess = list.emplace_back(Guess{first_word(typed), first_word(expected), {}});
    for (std::string word; fields >> word;) guess.words.push_back(word);
  }
  return list;
}

/// What the launcher guesses.
std::string by_awk(const std::string& typed, const Words& words) {
  Words command{"sh", "-c", R"(script=$1; shift; printf '%s\n' "$@" | LC_ALL=C awk -f "$script")",
                "sh", project / "framework/cli/nearest_word.awk"};
  command.insert(command.end(), words.begin(), words.end());
  const cs550::test::ScopedEnvironment variable("typed", typed);
  std::string printed = cs550::cli::output_of(command);
  if (!printed.empty()) printed.pop_back();
  return printed;
}

TEST(NearestWord, IsTheSameInTheProgramsAndInTheLauncher) {
  const std::vector<Guess> list = guesses();
  ASSERT_GT(list.size(), 20U);
  for (const Guess& guess : list) {
    EXPECT_EQ(cs550::nearest_word(guess.typed, guess.words), guess.expected) << guess.typed;
    EXPECT_EQ(by_awk(guess.typed, guess.words), guess.expected) << guess.typed;
  }
}

TEST(NearestWord, IsNotSoughtForTextOfAnyLength) {
  const std::string letters(100, 'a');
  for (const std::string& typed : {letters, letters + 'a'}) {
    const std::string expected = typed == letters ? letters + "ab" : "";
    EXPECT_EQ(cs550::nearest_word(typed, {letters + "ab"}), expected) << typed.size();
    EXPECT_EQ(by_awk(typed, {letters + "ab"}), expected) << typed.size();
  }
}

}  // namespace
