#include "engine/contacts/link_schedule.hpp"

#include <algorithm>
#include <utility>

namespace cs550 {

namespace {

/// Puts the links of a unit into groups of those that wait for no other (list scheduling). Links that share a
/// movable body wait for each other. Those that hold up the longest chains come first: what is left at the end
/// then fills whole groups, rather than being a chain.
class Schedule {
 public:
  Schedule(SolveOrder& order, SolveUnit& unit, std::size_t bodies) : order_(order), unit_(unit) {
    unit_.next_of_body.assign(bodies, no_index);
  }

  void run() {
    Index highest = 0;
    for (Index i = unit_.end_contact - 1; i >= unit_.first_contact; --i) {
      state(i) = {};
      tie_to_followers(i);
      highest = std::max(highest, state(i).height);
    }
    for (ReadyLinks& links : unit_.ready) {
      links.tops.assign(static_cast<std::size_t>(highest) + 1, no_index);
      links.height = 0;
    }
    for (Index i = unit_.end_contact - 1; i >= unit_.first_contact; --i) {
      if (state(i).waits_for == 0) make_ready(i);
    }
    while (const std::size_t points = longest_of_next_group()) form_group(points);
  }

 private:
  LinkState& state(Index link) { return order_.states[link]; }
  ReadyLinks& ready(std::size_t points) { return unit_.ready[points - 1]; }

  /// @pre done for all links of the unit after this one
  void tie_to_followers(Index i) {
    auto follower = state(i).followers.begin();
    for (const Index body : {order_.links[i].body_a, order_.links[i].body_b}) {
      if (body == no_index) continue;
      const Index next = std::exchange(unit_.next_of_body[body], i);
      if (next == no_index) continue;
      *follower++ = next;
      ++state(next).waits_for;
      state(i).height = std::max(state(i).height, state(next).height + 1);
    }
  }

  void make_ready(Index link) {
    ReadyLinks& links = ready(static_cast<std::size_t>(order_.links[link].points));
    const Index height = state(link).height;
    state(link).below = std::exchange(links.tops[height], link);
    links.height = std::max(links.height, height);
    ++links.count;
  }

  /// Passes over the stacks that have become empty. @pre there is a link
  Index height_of(ReadyLinks& links) {
    while (links.tops[links.height] == no_index) --links.height;
    return links.height;
  }

  Index take_highest(ReadyLinks& links) {
    Index& top = links.tops[height_of(links)];
    --links.count;
    return std::exchange(top, state(top).below);
  }

  /// The number of points of the highest link that is ready, if possible among as many as fill a group:
  /// a lane that has run out of points idles. @returns 0 if no link is left
  std::size_t longest_of_next_group() {
    for (const std::size_t enough : {lane_count, std::size_t(1)}) {
      std::size_t best = 0;
      for (std::size_t points = max_manifold_points; points > 0; --points) {
        if (ready(points).count < enough) continue;
        if (best == 0 || height_of(ready(points)) > height_of(ready(best))) best = points;
      }
      if (best > 0) return best;
    }
    return 0;
  }

  /// Links of that many points, then of fewer.
  void form_group(std::size_t points) {
    StaticVector<Index, lane_count> taken;
    for (; points > 0; --points) {
      while (!taken.full() && ready(points).count > 0) taken.push_back(take_highest(ready(points)));
    }
    ContactGroup& group = unit_.groups.emplace_back();
    for (const Index link : taken) {
      group.push_back(order_.links[link].contact);
      for (const Index follower : state(link).followers) {
        if (follower != no_index && --state(follower).waits_for == 0) make_ready(follower);
      }
    }
  }

  SolveOrder& order_;
  SolveUnit& unit_;
};

}  // namespace

void form_groups(SolveOrder& order, SolveUnit& unit, std::size_t bodies) {
  unit.groups.clear();
  if (unit.first_contact == unit.end_contact) return;  // as between most parts
  Schedule(order, unit, bodies).run();
}

}  // namespace cs550
