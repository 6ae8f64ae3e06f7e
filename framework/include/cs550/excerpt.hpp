#pragma once
/// @file excerpt.hpp
/// What messages repeat of a reader's own text.

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

}  // namespace cs550
