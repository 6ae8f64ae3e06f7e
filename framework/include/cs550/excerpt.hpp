#pragma once
/// @file excerpt.hpp
/// What messages repeat of a reader's own text.

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace cs550 {

/// A text as a message repeats it: control characters, which a terminal would obey, become `?`, and
/// what is longer than `longest` bytes ends with "...". UTF-8 characters are not cut in two.
inline std::string excerpt(std::string_view text, std::size_t longest = 60) {
  const auto is_continuation = [](char letter) {
    return (static_cast<unsigned char>(letter) & 0xc0) == 0x80;
  };
  const bool cut = text.size() > longest;
  if (cut) {
    std::size_t end = longest - 3;
    while (end > 0 && is_continuation(text[end])) --end;
    text = text.substr(0, end);
  }
  std::string result;
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    result += code < 0x20 || code == 0x7f ? '?' : letter;
  }
  return cut ? result + "..." : result;
}

/// A message for a terminal: words of hundreds of letters, from somebody's command line, are cut short.
inline std::string with_short_words(std::string_view message) {
  constexpr std::size_t longest = 300;  // a path in use is shorter
  std::string result;
  for (std::size_t begin = 0; begin < message.size();) {
    const std::size_t end = std::min(message.find_first_of(" \n", begin), message.size());
    result += excerpt(message.substr(begin, end - begin), longest);
    if (end < message.size()) result += message[end];
    begin = end + 1;
  }
  return result;
}

}  // namespace cs550
