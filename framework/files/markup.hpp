#pragma once
/// @file markup.hpp
/// Text inside of XML, SVG and HTML.

#include <string>
#include <string_view>

namespace cs550::files {

/// Escapes the five characters that XML reserves, so that the text can be an element's content or an
/// attribute. Control characters, which XML does not allow, are removed.
inline std::string escape_markup(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        if (static_cast<unsigned char>(letter) >= ' ' || letter == '\n' || letter == '\t') {
          result += letter;
        }
    }
  }
  return result;
}

}  // namespace cs550::files
