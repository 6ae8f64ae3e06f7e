#pragma once
/// @file nearest_word.hpp
/// What somebody probably meant to type.

#include <string>
#include <string_view>
#include <vector>

namespace cs550 {

/// The word that the fewest letters inserted, deleted or changed turn `typed` into (Levenshtein
/// 1966); empty if even that one differs in more than half of its letters, or if `typed` has more than 100.
std::string nearest_word(std::string_view typed, const std::vector<std::string>& words);

}  // namespace cs550
