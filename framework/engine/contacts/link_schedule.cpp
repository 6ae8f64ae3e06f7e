#include "engine/contacts/link_schedule.hpp"

#include <algorithm>
#include <utility>

namespace cs550 {

namespace {

/// Puts the links of a unit into groups of those that wait for no other (list scheduling). Links that share a
/// movable body wait for each other. Those that begin the longest chains come first: what is left at the end
/// then fills whole groups, rather than being a chain.
///
/// A group has as many rows as its longest link has points. Links of the same number of points therefore fill it best,
/// but while the chosen ones are not the first of the longest chain, that chain waits.
class Schedule {
 public:
  Schedule(SolveOrder& order, SolveUnit& unit, std::size_t bodies) : order_(order), unit_(unit) {
    unit_.next_of_body.assign(bodies, no_index);
  }

  void run() {
    Index longest = 0;
    for (Index i = unit_.end_contact - 1; i >= unit_.first_contact; --i) {
      state(i) = {};
      tie_to_followers(i);
      longest = std::max(longest, state(i).chain);
      cost_left_ += cost(i);
    }
    for (ReadyLinks& links : unit_.ready) {
      links.tops.assign(static_cast<std::size_t>(longest) + 1, no_index);
      links.longest = 0;
    }
    for (Index i = unit_.end_contact - 1; i >= unit_.first_contact; --i) {
      if (state(i).waits_for == 0) make_ready(i);
    }
    while (const std::size_t points = points_of_next_group()) form_group(points);
  }

 private:
  LinkState& state(Index link) { return order_.states[link]; }
  ReadyLinks& ready(std::size_t points) { return unit_.ready[points - 1]; }

  /// The rows of a link, and one for bringing its bodies into lanes and back.
  Index cost(Index link) const { return order_.links[link].points + 1; }

  /// @pre done for all links of the unit after this one
  void tie_to_followers(Index i) {
    auto follower = state(i).followers.begin();
    Index chain = 0;
    for (const Index body : {order_.links[i].body_a, order_.links[i].body_b}) {
      if (body == no_index) continue;
      const Index next = std::exchange(unit_.next_of_body[body], i);
      if (next == no_index) continue;
      *follower++ = next;
      ++state(next).waits_for;
      chain = std::max(chain, state(next).chain);
    }
    state(i).chain = chain + cost(i);
  }

  void make_ready(Index link) {
    ReadyLinks& links = ready(static_cast<std::size_t>(order_.links[link].points));
    const Index chain = state(link).chain;
    state(link).below = std::exchange(links.tops[chain], link);
    links.longest = std::max(links.longest, chain);
    ++links.count;
  }

  /// Passes over the stacks that have become empty. @pre there is a link
  Index longest_chain(ReadyLinks& links) {
    while (links.tops[links.longest] == no_index) --links.longest;
    return links.longest;
  }

  Index take_longest(ReadyLinks& links) {
    Index& top = links.tops[longest_chain(links)];
    --links.count;
    return std::exchange(top, state(top).below);
  }

  /// Looks for the ready link with the longest chain, and returns how many points it has. A number of points that fewer than
  /// `fewest` ready links have is passed over. @returns 0 if there is none
  std::size_t points_of_longest_chain(std::size_t fewest) {
    std::size_t best = 0;
    for (std::size_t points = max_manifold_points; points > 0; --points) {
      if (ready(points).count < fewest) continue;
      if (best == 0 || longest_chain(ready(points)) > longest_chain(ready(best))) best = points;
    }
    return best;
  }

  /// How many points the longest links of the next group have. The group begins with the longest chain if that would take
  /// more than half of the time that all links left would take in whole groups. Otherwise it is a whole group of links with
  /// as many points each, if there is one. @returns 0 if no link is left
  std::size_t points_of_next_group() {
    const std::size_t longest = points_of_longest_chain(1);
    if (longest == 0) return 0;
    constexpr auto lanes = static_cast<Index>(lane_count);
    if (longest_chain(ready(longest)) > cost_left_ / lanes / 2) return longest;
    const std::size_t of_whole_group = points_of_longest_chain(lane_count);
    return of_whole_group > 0 ? of_whole_group : longest;
  }

  /// Links of that many points, then of fewer.
  void form_group(std::size_t points) {
    StaticVector<Index, lane_count> taken;
    for (; points > 0; --points) {
      while (!taken.full() && ready(points).count > 0) taken.push_back(take_longest(ready(points)));
    }
    ContactGroup& group = unit_.groups.emplace_back();
    for (const Index link : taken) {
      group.push_back(order_.links[link].contact);
      cost_left_ -= cost(link);
      for (const Index follower : state(link).followers) {
        if (follower != no_index && --state(follower).waits_for == 0) make_ready(follower);
      }
    }
  }

  SolveOrder& order_;
  SolveUnit& unit_;
  Index cost_left_ = 0;  ///< of all links that are in no group yet
};

}  // namespace

void form_groups(SolveOrder& order, SolveUnit& unit, std::size_t bodies) {
  unit.groups.clear();
  if (unit.first_contact == unit.end_contact) return;  // as between most parts
  Schedule(order, unit, bodies).run();
}

}  // namespace cs550
