#include "terminal.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace cs550::cli {
namespace {

/// https://no-color.org: any value but an empty one asks for plain text.
bool shows_colours() {
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return isatty(STDOUT_FILENO) != 0 && (no_color == nullptr || *no_color == '\0') &&
         (terminal == nullptr || std::string_view(terminal) != "dumb");
}

const char* escape_code(Colour colour) {
  switch (colour) {
    case Colour::Red:
      return "31";
    case Colour::Green:
      return "32";
    case Colour::Yellow:
      return "33";
    case Colour::Bold:
      return "1";
    case Colour::Faint:
      return "2";
  }
  return "0";
}

/// How many characters a UTF-8 text shows: its bytes but for those that continue a character.
std::size_t columns(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xC0) != 0x80; }));
}

/// Where the text of a line begins, behind its indentation and a label: "  likely    compare ...".
std::size_t start_of_text(const std::string& line) {
  constexpr std::size_t last_column_of_labels = 16;
  const std::size_t label = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t text = line.find_first_not_of(' ', line.find("  ", label));
  return text < last_column_of_labels ? text : label;
}

}  // namespace

std::string coloured(std::string_view text, Colour colour) {
  static const bool show = shows_colours();
  if (!show) return std::string(text);
  return std::string("\033[") + escape_code(colour) + 'm' + std::string(text) + "\033[0m";
}

std::string indented(std::string_view text, std::size_t spaces) {
  constexpr std::size_t last_column = 80;
  const std::size_t width = last_column - spaces;
  std::istringstream lines{std::string(text)};
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t start = start_of_text(line);
    while (columns(line) > width) {
      const std::size_t space = line.rfind(' ', width);
      if (space == std::string::npos || space <= start) break;
      result += std::string(spaces, ' ') + line.substr(0, space) + '\n';
      line.replace(0, space + 1, std::string(start, ' '));
    }
    result += (line.empty() ? "" : std::string(spaces, ' ')) + line + '\n';
  }
  return result;
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, text.size()), ' ');
}

}  // namespace cs550::cli
