/// The seam holds only what passes through it: a lab's header declares exactly the functions that its
/// reference defines, and none that the lab is to write has its body in the header. That the starter
/// and the student define the same ones is checked by the build, which refuses one that is missing
/// (isolate_object.cmake) or not declared (-Wmissing-declarations).
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
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

struct Header {
  Names declared;
  Names inline_steps;  ///< functions that a lab is to write, yet have a body here
};

/// The text at namespace scope: comments and preprocessor lines removed, `@` left where a comment
/// names a step of a lab, and of the bodies of types and functions only `{}` left.
std::string namespace_scope(std::string text) {
  text = std::regex_replace(text, std::regex(R"(//[^\n]*\*\*L\d\.\d[^\n]*)"), "@");
  text = std::regex_replace(text, std::regex("//[^\n]*|#[^\n]*"), "");
  text = std::regex_replace(text, std::regex(R"(namespace\s+\w+\s*\{)"), "");
  std::string outside;
  int depth = 0;
  for (const char c : text) {
    if (c == '{' && depth++ == 0) {
      outside += "{}";
    } else if (c == '}') {
      --depth;
    } else if (depth == 0) {
      outside += c;
    }
  }
  return outside;
}

Header parse(const std::string& header) {
  const std::string text = namespace_scope(header);
  // A name, its parameters with at most one nested pair of parentheses, then `;` or a body.
  const std::regex function(R"((@?)[^;@}]*?\b(\w+)\s*\(([^()]|\([^()]*\))*\)\s*(;|\{\}))");
  Header found;
  for (std::sregex_iterator match(text.begin(), text.end(), function), end; match != end; ++match) {
    if ((*match)[4] == ";") {
      found.declared.push_back((*match)[2]);
    } else if ((*match)[1] == "@") {
      found.inline_steps.push_back((*match)[2]);
    }
  }
  std::sort(found.declared.begin(), found.declared.end());
  return found;
}

/// The names of functions in namespace cs550, from a list of mangled names: _ZN5cs550<length><name>.
Names unqualified(const std::string& symbols) {
  Names names;
  std::istringstream lines(symbols);
  for (std::string symbol; std::getline(lines, symbol);) {
    const std::string prefix = "_ZN5cs550";
    std::size_t digits = 0;
    const int length = std::stoi(symbol.substr(prefix.size()), &digits);
    names.push_back(symbol.substr(prefix.size() + digits, static_cast<std::size_t>(length)));
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST(HeaderReader, TellsDeclarationsFromInlineFunctions) {
  const Header header = parse(R"(#pragma once
namespace cs550 {
struct Point { int x = 0; int sum() const { return x; } };
/// **L1.1** Not a function(); a comment.
int walk(const Point& p, std::function<int(int)> f = nullptr,
         Point start = {});
/// Given.
inline int given(int a) { return a; }
/// **L1.2** Logic that no lab could replace.
inline int shortcut(int a) { return a; }
constexpr int limit = 3;
}  // namespace cs550
)");
  EXPECT_EQ(header.declared, Names{"walk"});
  EXPECT_EQ(header.inline_steps, Names{"shortcut"});
}

class Contract : public testing::TestWithParam<std::string> {};

/// "1:integration,3:hill_climbing" split at the commas.
Names labs() {
  Names names;
  std::istringstream list(CS550_ISOLATED_LABS);
  for (std::string name; std::getline(list, name, ',');) {
    names.push_back(name);
  }
  return names;
}

TEST_P(Contract, HeaderDeclaresWhatTheReferenceDefines) {
  const std::string number = GetParam().substr(0, GetParam().find(':'));
  const std::string topic = GetParam().substr(GetParam().find(':') + 1);
  const Header header = parse(read(std::string(CS550_HEADERS) + "/" + topic + ".hpp"));
  ASSERT_FALSE(header.declared.empty());
  EXPECT_EQ(unqualified(read(std::string(CS550_SYMBOL_LISTS) + "/lab" + number + ".symbols")),
            header.declared);
  EXPECT_EQ(header.inline_steps, Names{}) << "cannot be substituted at link time";
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Contract);
INSTANTIATE_TEST_SUITE_P(Labs, Contract, testing::ValuesIn(labs()), [](const auto& test) {
  return test.param.substr(test.param.find(':') + 1);
});

}  // namespace
