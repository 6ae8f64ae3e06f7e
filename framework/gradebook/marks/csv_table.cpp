#include "gradebook/marks/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace cs550::gradebook {
namespace {

/// A quote at `start` is not closed where it should be.
std::runtime_error open_quote(const std::string& text, std::size_t start, const std::string& file) {
  const auto breaks =
      std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(start), '\n');
  return std::runtime_error(
      fmt::format("{}:{}: a quote is opened and not closed. Close it at the end of its field.\n"
                  "  A quote inside quotes is written twice: \"Ada \"\"Countess\"\" Lovelace\"",
                  file, breaks + 1));
}

/// Whether the quoted text from `start` to `end` swallowed lines: it has a line break, and what follows it
/// is not the end of a field.
bool swallows_lines(const std::string& text, std::size_t start, std::size_t end, char separator) {
  if (text.find('\n', start) >= end || end + 1 == text.size()) return false;
  const char next = text[end + 1];
  return next != separator && next != '\r' && next != '\n';
}

}  // namespace

std::vector<std::vector<std::string>> parse_csv(const std::string& text, const std::string& file) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  const std::string first_line = text.substr(0, text.find('\n'));
  const char separator = first_line.find(',') == std::string::npos ? ';' : ',';
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row;
  std::string field;
  bool quoted = false;
  std::size_t quote = 0;  // where the last quoted text begins
  const auto end_row = [&] {
    row.push_back(std::exchange(field, {}));
    if (row.size() > 1 || !row[0].empty()) rows.push_back(row);
    row.clear();
  };
  for (std::size_t i = text.starts_with(byte_order_mark) ? 3 : 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      field += text[++i];
    } else if (c == '"') {
      if (quoted && swallows_lines(text, quote, i, separator)) throw open_quote(text, quote, file);
      if (!quoted) quote = i;
      quoted = !quoted;
    } else if (!quoted && c == separator) {
      row.push_back(std::exchange(field, {}));
    } else if (!quoted && c == '\n') {
      end_row();
    } else if (quoted || c != '\r') {
      field += c;
    }
  }
  if (quoted) throw open_quote(text, quote, file);
  end_row();
  return rows;
}

}  // namespace cs550::gradebook
