#pragma once
/// @file excerpt.hpp
/// What messages repeat of a reader's own text.

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace cs550 {

/// The length in bytes of the control character at the start of a text: 1, or 2 for those from U+0080 to
/// U+009F (C2 80 to C2 9F in UTF-8), which some terminals obey as well; 0 if the text starts otherwise.
inline std::size_t control_length(std::string_view text) {
  if (text.empty()) return 0;
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x20 || first == 0x7f) return 1;
  const auto second = static_cast<unsigned char>(text.size() > 1 ? text[1] : 0);
  return first == 0xc2 && second >= 0x80 && second < 0xa0 ? 2 : 0;
}

/// A text as a message repeats it: control characters, which a terminal would obey, become `?`, and
/// what is longer than `longest` bytes ends with "...". UTF-8 characters are not cut in two.
inline std::string excerpt(std::string_view text, std::size_t longest = 60) {
  const auto is_continuation = [](char letter) {
    return (static_cast<unsigned char>(letter) & 0xc0) == 0x80;
  };
  const bool cut = text.size() > longest;
  if (cut) {
    std::size_t end = std::max<std::size_t>(longest, 3) - 3;
    while (end > 0 && is_continuation(text[end])) --end;
    text = text.substr(0, end);
  }
  std::string result;
  while (!text.empty()) {
    const std::size_t control = control_length(text);
    result += control > 0 ? '?' : text[0];
    text.remove_prefix(std::max<std::size_t>(control, 1));
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
