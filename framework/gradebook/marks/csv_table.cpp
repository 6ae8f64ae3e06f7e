#include "gradebook/marks/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace cs550::gradebook {
namespace {

constexpr std::string_view blanks = " \t";

/// A quote at `where` is not what RFC 4180 allows.
std::runtime_error wrong_quote(const std::string& text, std::size_t where, const std::string& file,
                               std::string_view fault) {
  const auto breaks =
      std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(where), '\n');
  return std::runtime_error(
      fmt::format("{}:{}: {}\n"
                  "  A quote inside quotes is written twice: \"Ada \"\"Countess\"\" Lovelace\"",
                  file, breaks + 1, fault));
}

constexpr std::string_view open_quote =
    "a quote is opened and not closed. Close it at the end of its field.";
constexpr std::string_view inner_quote =
    "a quote inside of a field. Put the whole field into quotes.";
constexpr std::string_view early_quote =
    "text follows a quote that closes. Close the quote at the end of its field.";

/// What is wrong with quoted text from `start` that is followed by more text at `next`: if it has a line
/// break, it has swallowed lines.
std::string_view fault_before(const std::string& text, std::size_t start, std::size_t next) {
  return text.find('\n', start) < next ? open_quote : early_quote;
}

}  // namespace

std::vector<std::vector<std::string>> parse_csv(const std::string& text, const std::string& file) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  const std::string first_line = text.substr(0, text.find('\n'));
  const char separator = first_line.find(',') == std::string::npos ? ';' : ',';
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row;
  std::string field;
  enum class Field { Plain, Quoted, Closed } state = Field::Plain;
  std::size_t quote = 0;  // where the last quoted text begins
  const auto end_field = [&] {
    row.push_back(std::exchange(field, {}));
    state = Field::Plain;
  };
  const auto end_row = [&] {
    end_field();
    if (row.size() > 1 || !row[0].empty()) rows.push_back(row);
    row.clear();
  };
  for (std::size_t i = text.starts_with(byte_order_mark) ? 3 : 0; i < text.size(); ++i) {
    const char c = text[i];
    if (state == Field::Quoted) {
      const bool is_twice = text.compare(i, 2, "\"\"") == 0;
      if (c != '"' || is_twice) {
        field += c;
        i += is_twice ? 1 : 0;
      } else {
        state = Field::Closed;
      }
    } else if (c == separator) {
      end_field();
    } else if (c == '\n') {
      end_row();
    } else if (state == Field::Closed && c != '\r' && blanks.find(c) == blanks.npos) {
      throw wrong_quote(text, quote, file, fault_before(text, quote, i));
    } else if (c == '"') {
      if (field.find_first_not_of(blanks) != field.npos) {
        throw wrong_quote(text, i, file, inner_quote);
      }
      quote = i;
      state = Field::Quoted;
    } else if (c != '\r') {
      field += c;
    }
  }
  if (state == Field::Quoted) throw wrong_quote(text, quote, file, open_quote);
  end_row();
  return rows;
}

}  // namespace cs550::gradebook
