#include "gradebook/marks/csv_table.hpp"

#include <string_view>
#include <utility>

namespace cs550::gradebook {

std::vector<std::vector<std::string>> parse_csv(const std::string& text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  const std::string first_line = text.substr(0, text.find('\n'));
  const char separator = first_line.find(',') == std::string::npos ? ';' : ',';
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row;
  std::string field;
  bool quoted = false;
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
      quoted = !quoted;
    } else if (!quoted && c == separator) {
      row.push_back(std::exchange(field, {}));
    } else if (!quoted && c == '\n') {
      end_row();
    } else if (quoted || c != '\r') {
      field += c;
    }
  }
  end_row();
  return rows;
}

}  // namespace cs550::gradebook
