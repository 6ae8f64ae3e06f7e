/// Link-time substitution needs complete headers: a lab's header declares exactly the functions
/// that its reference defines, and no function of a step is defined in the header. The build checks
/// that starters and students define the same functions: the linker reports a missing one, and the
/// compiler one that is not declared (-Wmissing-declarations).
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

/// Sorted, one entry per overload.
using Names = std::vector<std::string>;

std::string read(const std::string& path) {
  std::ifstream stream(path);
  EXPECT_TRUE(stream) << "cannot read " << path;
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The functions with a step of the lab in their comment.
struct Header {
  Names declared;
  Names inline_steps;  ///< defined in the header
};

/// The statements at namespace scope, without comments, preprocessor lines and the bodies of types
/// and functions. A statement with a body ends in `{`. A comment with a step is replaced by `@`.
std::vector<std::string> statements(std::string text) {
  text = std::regex_replace(text, std::regex(R"(//[^\n]*\*\*L\d+\.\d[^\n]*)"), "@");
  text = std::regex_replace(text, std::regex("//[^\n]*|#[^\n]*"), "");
  text = std::regex_replace(text, std::regex(R"(namespace\s+\w+\s*\{)"), "");
  std::vector<std::string> found(1);
  int braces = 0;
  int parentheses = 0;
  for (const char c : text) {
    parentheses += (c == '(') - (c == ')');
    if (braces == 0 && c != '}') {
      found.back() += c;
    }
    braces = std::max(0, braces + (c == '{') - (c == '}'));
    if (braces == 0 && parentheses == 0 && (c == ';' || c == '}')) {
      found.emplace_back();
    }
  }
  return found;
}

Header parse(const std::string& header) {
  const std::regex step(R"([^]*@[^=(]*\b(\w+)\s*\([^]*)");
  Header found;
  for (const std::string& statement : statements(header)) {
    std::smatch name;
    if (std::regex_match(statement, name, step)) {
      (statement.back() == '{' ? found.inline_steps : found.declared).push_back(name[1]);
    }
  }
  std::sort(found.declared.begin(), found.declared.end());
  return found;
}

/// The functions of a lab, from rows with its number, name and mangled name.
Names defined_functions(const std::string& lab) {
  const std::regex row(R"x(CS550_LAB_FUNCTION\((\d+), (\w+), "_ZN5cs550\w+"\))x");
  const std::string rows = read(CS550_LAB_FUNCTIONS);
  Names names;
  for (std::sregex_iterator found(rows.begin(), rows.end(), row), end; found != end; ++found) {
    const std::smatch& match = *found;
    if (match[1] == lab) names.push_back(match[2]);
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST(HeaderReader, TellsDeclarationsFromInlineFunctions) {
  const Header header = parse(R"(#pragma once
namespace cs550 {
struct Point { int x = 0; int sum() const { return x; } };
/// Given, defined elsewhere.
const char* describe(int a);
/// **L1.1** Not a function(); a comment.
/// It has (L1.3) more.
int walk(const Point& p, std::function<int(int)> f = nullptr,
         Point start = {});
/// Given.
inline int given(int a) { return a; }
/// **L1.2** Logic that no lab could replace.
inline int shortcut(int a) { return a; }
/// **L1.2** has no more than
constexpr int limit = int(3);
}  // namespace cs550
)");
  EXPECT_EQ(header.declared, Names{"walk"});
  EXPECT_EQ(header.inline_steps, Names{"shortcut"});
}

class Contract : public testing::TestWithParam<std::string> {};

/// "lab1_integration lab3_hill_climbing" as words.
Names labs() {
  std::istringstream list(CS550_ISOLATED_LABS);
  return {std::istream_iterator<std::string>(list), {}};
}

TEST_P(Contract, HeaderDeclaresWhatTheReferenceDefines) {
  std::smatch name;
  ASSERT_TRUE(std::regex_match(GetParam(), name, std::regex(R"(lab(\d+)_(\w+))")));
  const Header header = parse(read(std::string(CS550_HEADERS) + "/" + name.str(2) + ".hpp"));
  ASSERT_FALSE(header.declared.empty());
  EXPECT_EQ(defined_functions(name[1]), header.declared);
  EXPECT_EQ(header.inline_steps, Names{}) << "cannot be substituted at link time";
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Contract);
INSTANTIATE_TEST_SUITE_P(Labs, Contract, testing::ValuesIn(labs()),
                         [](const auto& test) { return test.param; });

}  // namespace
