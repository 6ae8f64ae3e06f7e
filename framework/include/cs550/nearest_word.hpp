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

/// The fewest letters to insert, delete or change (Levenshtein 1966), by rows of the usual table.
inline std::size_t edit_distance(std::string_view from, std::string_view to) {
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

/// The only word that begins with `typed`, if that has at least three letters. Otherwise the word
/// that the fewest letters inserted, deleted or changed turn `typed` into; empty if even that one
/// differs in more than half of its letters, or if `typed` has more than 100.
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
    if (distance < least && 2 * distance <= word.size()) {
      nearest = word;
      least = distance;
    }
  }
  return nearest;
}

}  // namespace cs550
