#include "engine/pairs/pair_list.hpp"

#include <algorithm>

namespace cs550 {

namespace {

/// Calls `visit(array)` for every array that has an element for each pair. If there is a team, one thread visits
/// the contacts, which are more than half of the bytes, and another one the other arrays.
template <class Visit>
void for_arrays(PairList& pairs, const Visit& visit, ThreadTeam* team = nullptr) {
  const auto visit_all = [&](auto&... arrays) { (visit(arrays), ...); };
  for_blocks(team, 2, 1, [&](std::size_t first, std::size_t last) {
    if (first == 0) visit(pairs.contacts);
    if (last == 2) {
      visit_all(pairs.summaries, pairs.axes, pairs.memories, pairs.answers, pairs.touching,
                pairs.impulse_energy, pairs.misplaced);
    }
  });
}

/// Moves the elements of stretches to their places. No stretch moves past another, so those that move to the
/// front do not meet what is still to be moved if they begin with the first, and the others if they begin
/// with the last.
template <class Item>
void move_stretches(std::span<const PairStretch> stretches, std::vector<Item>& items) {
  const auto at = [&](std::size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); };
  for (const auto [first, last, to] : stretches) {
    if (to < first) std::move(at(first), at(last), at(to));
  }
  for (auto stretch = stretches.rbegin(); stretch != stretches.rend(); ++stretch) {
    const auto [first, last, to] = *stretch;
    if (to > first) std::move_backward(at(first), at(last), at(to + last - first));
  }
}

/// Puts a pair that has not been queried yet at index `i`.
void place(PairList& pairs, std::size_t i, std::uint64_t key) {
  for_arrays(pairs, [&](auto& array) { array[i] = {}; });
  PairSummary& summary = pairs.summaries[i];
  summary.body_a = pairs.contacts[i].body_a = static_cast<Index>(key >> 32);
  summary.body_b = pairs.contacts[i].body_b = static_cast<Index>(key & 0xffffffffU);
}

}  // namespace

std::uint64_t pair_key(Index a, Index b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 |
         static_cast<std::uint64_t>(std::max(a, b));
}

std::uint64_t pair_key(const PairSummary& pair) { return pair_key(pair.body_a, pair.body_b); }

void PairList::summarise(std::size_t pair) {
  const Manifold& manifold = contacts[pair].manifold;
  PairSummary& summary = summaries[pair];
  summary.points = manifold.points.size();
  summary.depth = 0;
  for (const ContactPoint& point : manifold.points) {
    summary.depth = std::max(summary.depth, -point.separation);
  }
  summary.bounces = contacts[pair].restitution > 0;
}

void PairList::clear() {
  for_arrays(*this, [](auto& array) { array.clear(); });
}

void PairList::make_room(std::size_t count) {
  if (count <= contacts.capacity()) return;
  for_arrays(*this, [&](auto& array) { array.reserve(2 * count); });
}

void PairList::append(const PairList& other, std::size_t i) {
  contacts.push_back(other.contacts[i]);
  summaries.push_back(other.summaries[i]);
  axes.push_back(other.axes[i]);
  memories.push_back(other.memories[i]);
  answers.push_back(other.answers[i]);
  touching.push_back(other.touching[i]);
  impulse_energy.push_back(other.impulse_energy[i]);
  misplaced.push_back(other.misplaced[i]);
}

PairListEdit::PairListEdit(PairList& pairs) : pairs_(pairs) {
  pairs_.stretches.clear();
  pairs_.inserted.clear();
}

void PairListEdit::drop(std::size_t i) {
  end_stretch(i);
  first_ = i + 1;
}

void PairListEdit::insert(std::size_t i, std::uint64_t key) {
  end_stretch(i);
  pairs_.inserted.push_back({to_++, key});
}

void PairListEdit::end_stretch(std::size_t last) {
  if (first_ < last) pairs_.stretches.push_back({first_, last, to_});
  to_ += last - first_;
  first_ = last;
}

void PairListEdit::apply(ThreadTeam* team) {
  end_stretch(pairs_.size());
  pairs_.make_room(to_);
  const std::size_t largest = std::max(to_, pairs_.size());
  const auto move = [&](auto& array) {
    array.resize(largest);
    move_stretches(std::span<const PairStretch>(pairs_.stretches), array);
    array.resize(to_);
  };
  for_arrays(pairs_, move, team);
  for (const InsertedPair& pair : pairs_.inserted) place(pairs_, pair.to, pair.key);
}

void move_pairs(PairList& from, PairList& to, PairList& scratch, const std::vector<char>& moves) {
  scratch.clear();
  scratch.make_room(from.size() + to.size());
  std::size_t in_to = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (!moves[i]) continue;
    const std::uint64_t key = pair_key(from.summaries[i]);
    for (; in_to < to.size() && pair_key(to.summaries[in_to]) < key; ++in_to) {
      scratch.append(to, in_to);
    }
    scratch.append(from, i);
  }
  for (; in_to < to.size(); ++in_to) scratch.append(to, in_to);
  std::swap(to, scratch);

  PairListEdit edit(from);
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (moves[i]) edit.drop(i);
  }
  edit.apply();
}

}  // namespace cs550
