/// A graded test describes a fact with a value as "name = value", so the name must read well before "=".
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The matches of a pattern in the graded tests, with their files.
std::vector<std::string> found_in_graded_tests(const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (const fs::directory_entry& lab :
       fs::directory_iterator(fs::path(CS550_TEST_DATA).parent_path())) {
    if (lab.path().filename().string().rfind("lab", 0) != 0) continue;
    for (const fs::directory_entry& file : fs::recursive_directory_iterator(lab)) {
      if (file.is_directory()) continue;
      const std::string text = text_of(file);
      for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end;
           ++match) {
        found.push_back(file.path().string() + ": " + match->str());
      }
    }
  }
  return found;
}

TEST(StoryFacts, NoNameStopsInTheMiddleOfAPhrase) {
  EXPECT_EQ(
      found_in_graded_tests(
          R"re(given\(\s*"[^"]*\b(about|at|by|of|of number|of side|of size|the|up to|without number)"\s*,)re"),
      std::vector<std::string>())
      << "given(\"two cubes, B at\", place) prints \"two cubes, B at = (1, 0, 0)\"";
}

TEST(StoryFacts, NoUnitContinuesASentence) {
  EXPECT_EQ(found_in_graded_tests(R"re(given\("[^"]*", [^;"]*, "is )re"),
            std::vector<std::string>())
      << "given(\"triangle\", 5, \"is missing\") prints \"triangle = 5 is missing\"";
}

}  // namespace
