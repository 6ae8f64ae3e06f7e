/// Every lab function of the contract is called with serialised arguments in one of these files.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>

namespace cs550::test {
namespace {

namespace fs = std::filesystem;

const fs::path root = fs::path(CS550_ASSETS) / "../..";

/// The functions with a step in their comment, in all headers of the contract.
std::set<std::string> declared_lab_functions() {
  const std::regex step(R"(\*\*L\d+\.\d+\*\*)");
  const std::regex function(R"((\w+)\()");
  std::set<std::string> names;
  for (const fs::path& header : fs::directory_iterator(root / "framework/include/cs550")) {
    std::ifstream file(header);
    bool belongs_to_a_lab = false;
    for (std::string line; std::getline(file, line);) {
      std::smatch match;
      if (line.starts_with("///")) {
        belongs_to_a_lab = belongs_to_a_lab || std::regex_search(line, step);
      } else if (belongs_to_a_lab && std::regex_search(line, match, function)) {
        names.insert(match[1]);
        belongs_to_a_lab = false;
      }
    }
  }
  return names;
}

std::set<std::string> called_functions() {
  const std::regex call(R"(^ *EXPECT_SAME_ACROSS_WIRE\((\w+))");
  std::set<std::string> names;
  for (const fs::path& test : fs::directory_iterator(root / "tests/serialisation")) {
    std::ifstream file(test);
    for (std::string line; std::getline(file, line);) {
      std::smatch match;
      if (std::regex_search(line, match, call)) names.insert(match[1]);
    }
  }
  return names;
}

TEST(Serialisation, CallsEveryFunctionThatTheHeadersDeclare) {
  EXPECT_EQ(called_functions(), declared_lab_functions())
      << "a lab's functions are called in tests/serialisation/labN_topic_test.cpp";
  EXPECT_GE(called_functions().size(), 36U) << "of the first seven labs";
}

}  // namespace
}  // namespace cs550::test
