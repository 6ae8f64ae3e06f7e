#pragma once
/// @file nearest_word.hpp
/// What somebody probably meant to type.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace cs550 {

/// The fewest letters to insert, delete, change or swap with their neighbour: the optimal string
/// alignment distance, by rows of the usual table.
inline std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  std::vector<std::size_t> last = row;
  std::vector<std::size_t> last_but_one = row;
  for (std::size_t i = 1; i <= from.size(); ++i) {
    last_but_one.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t changed = last[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
      row[j] = std::min({changed, row[j - 1] + 1, last[j] + 1});
      const bool is_swap = i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1];
      if (is_swap) row[j] = std::min(row[j], last_but_one[j - 2] + 1);
    }
  }
  return row.back();
}

/// The only word that begins with `typed`, if that has at least three letters. Otherwise the word
/// with the least edit distance from `typed`; empty if more than a third of its letters differ
/// (one may differ in a shorter word), if no letter is the same, or if `typed` has more than 100.
inline std::string nearest_word(std::string_view typed, const std::vector<std::string>& words) {
  constexpr std::size_t longest = 100;  // a scene may hold words of megabytes
  constexpr std::size_t shortest_start = 3;
  if (typed.size() > longest) return {};
  const auto begins_so = [typed](const std::string& word) {
    return std::string_view(word).substr(0, typed.size()) == typed;
  };
  if (typed.size() >= shortest_start && std::count_if(words.begin(), words.end(), begins_so) == 1) {
    return *std::find_if(words.begin(), words.end(), begins_so);
  }
  std::string nearest;
  std::size_t least = typed.size();
  for (const std::string& word : words) {
    if (word.size() > 2 * longest) continue;
    const std::size_t distance = edit_distance(typed, word);
    if (distance < least && distance <= std::max<std::size_t>(word.size() / 3, 1)) {
      nearest = word;
      least = distance;
    }
  }
  return nearest;
}

}  // namespace cs550
