#include "engine/scenes/nearest_word.hpp"

#include <algorithm>
#include <numeric>

namespace cs550 {
namespace {

/// The fewest letters to insert, delete or change, row by row of the usual table.
std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t changed = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_word(std::string_view typed, const std::vector<std::string>& words) {
  constexpr std::size_t longest = 100;  // a scene may hold words of megabytes
  if (typed.size() > longest) return {};
  std::string nearest;
  std::size_t least = typed.size();
  for (const std::string& word : words) {
    if (word.size() > 2 * longest) continue;
    const std::size_t distance = edit_distance(typed, word);
    if (distance < least && 2 * distance <= word.size()) {
      nearest = word;
      least = distance;
    }
  }
  return nearest;
}

}  // namespace cs550
