#include "files/indented.hpp"

#include <algorithm>
#include <sstream>

namespace cs550::files {
namespace {

constexpr std::size_t last_column = 80;

/// How many characters a UTF-8 text shows: its bytes but for those that continue a character.
std::size_t columns(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xC0) != 0x80; }));
}

/// The column in which the text of a line begins, after its indentation and a label: "  likely
/// compare ...".
std::size_t start_of_text(const std::string& line) {
  constexpr std::size_t last_column_of_labels = 16;
  const std::size_t label = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t text = line.find_first_not_of(' ', line.find("  ", label));
  return text < last_column_of_labels ? text : label;
}

/// Removes the word that begins at `start`, with the label before it. @return both, the word on a line
/// of its own and as far left as its length demands
std::string take_long_word(std::string& line, std::size_t start, std::size_t spaces) {
  const std::size_t end = std::min(line.find(' ', start), line.size());
  const std::string word = line.substr(start, end - start);
  std::string label = line.substr(0, start);
  label.erase(label.find_last_not_of(' ') + 1);
  line.replace(0, std::min(end + 1, line.size()), std::string(start, ' '));
  const std::size_t room = last_column - std::min(last_column, columns(word));
  return (label.empty() ? "" : std::string(spaces, ' ') + label + '\n') +
         std::string(std::min(spaces + start, room), ' ') + word + '\n';
}

}  // namespace

std::string indented(std::string_view text, std::size_t spaces) {
  const std::size_t width = last_column - spaces;
  std::istringstream lines{std::string(text)};
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t start = start_of_text(line);
    bool is_used_up = false;
    while (columns(line) > width) {
      const std::size_t space = line.rfind(' ', width);
      if (space == std::string::npos || space <= start) {
        result += take_long_word(line, start, spaces);
        is_used_up = line.size() <= start;
        continue;
      }
      result += std::string(spaces, ' ') + line.substr(0, space) + '\n';
      line.replace(0, space + 1, std::string(start, ' '));
    }
    if (!is_used_up) result += (line.empty() ? "" : std::string(spaces, ' ')) + line + '\n';
  }
  return result;
}

}  // namespace cs550::files
