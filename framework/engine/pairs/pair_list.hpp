#pragma once
/// @file pair_list.hpp
/// Changes of a list of pairs, which stays sorted.

#include "engine/world_state.hpp"

namespace cs550 {

/// Sorts like (a, b) with a < b.
std::uint64_t pair_key(Index a, Index b);
std::uint64_t pair_key(const PairSummary& pair);

/// Drops pairs of a list and inserts others, all at once. Of thousands of pairs a step changes a few dozen.
/// The others move by a few places or none, within their arrays.
/// @pre the changes are given in the order of the list
class PairListEdit {
 public:
  explicit PairListEdit(PairList& pairs);
  /// Drops the pair at index `i` of the list as it is before the edit.
  void drop(std::size_t i);
  /// Inserts a pair that has not been queried yet before the pair that is at index `i` before the edit.
  /// @param key see pair_key()
  void insert(std::size_t i, std::uint64_t key);
  /// Carries out the changes.
  /// @param team that shares the work, if there is one
  void apply(ThreadTeam* team = nullptr);
  /// The pairs that apply() has inserted. Their contacts have bodies only.
  std::span<const InsertedPair> inserted() const { return pairs_.inserted; }

 private:
  void end_stretch(std::size_t last);

  PairList& pairs_;
  std::size_t first_ = 0;  ///< of the present stretch
  std::size_t to_ = 0;     ///< where its pairs go
};

/// Moves some pairs from one list to another.
/// @param moves of each pair of `from`
/// @param scratch working storage
void move_pairs(PairList& from, PairList& to, PairList& scratch, const std::vector<char>& moves);

}  // namespace cs550
