#include "files/usage_fault.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string_view>
#include <vector>

namespace cs550::files {

namespace {

bool begins_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

/// The library lists words that it did not expect last one first.
std::string unexpected(const std::string& words) {
  std::istringstream list(words);
  std::vector<std::string> typed{std::istream_iterator<std::string>(list), {}};
  std::reverse(typed.begin(), typed.end());
  const auto option = std::find_if(typed.begin(), typed.end(),
                                   [](const std::string& word) { return begins_with(word, "-"); });
  if (option != typed.end()) return "there is no option " + *option;
  std::string result = "not expected:";
  for (const std::string& word : typed) result += ' ' + word;
  return result;
}

}  // namespace

std::string usage_fault(const std::string& words) {
  const std::size_t flag_end = words.find(" was given a disallowed flag override");
  if (flag_end != std::string::npos) return "--" + words.substr(0, flag_end) + " takes no value";
  // The message itself speaks of a lab or a scene.
  for (const std::string_view argument : {"N: ", "SCENE: "}) {
    if (begins_with(words, argument)) return words.substr(argument.size());
  }
  for (const std::string_view start : {"The following argument was not expected: ",
                                       "The following arguments were not expected: "}) {
    if (begins_with(words, start)) return unexpected(words.substr(start.size()));
  }
  return words;
}

}  // namespace cs550::files
