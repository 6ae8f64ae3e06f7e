#include "engine/contacts/solve_order.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cs550 {

namespace {

/// Makes room for twice as many items if there is not enough for `count`.
template <class... Arrays>
void make_room(std::size_t count, Arrays&... arrays) {
  constexpr std::size_t fewest = 128;
  const auto reserve = [&](auto& array) {
    if (array.capacity() < count) array.reserve(2 * std::max(count, fewest));
  };
  (reserve(arrays), ...);
}

/// Puts links into groups of those that wait for no other (list scheduling). Links that share a movable body
/// wait for each other. Those that hold up the longest chains come first: what is left at the end then fills
/// whole groups, rather than being a chain.
class Schedule {
 public:
  Schedule(SolveOrder& order, std::size_t bodies) : order_(order) {
    order_.groups.clear();
    order_.states.clear();
    order_.states.resize(order_.links.size());
    order_.next_of_body.assign(bodies, no_index);
  }

  void run() {
    Index highest = 0;
    for (Index i = link_count() - 1; i >= 0; --i) {
      tie_to_followers(i);
      highest = std::max(highest, state(i).height);
    }
    for (ReadyLinks& links : order_.ready) {
      links.tops.assign(static_cast<std::size_t>(highest) + 1, no_index);
      links.height = 0;
    }
    for (Index i = link_count() - 1; i >= 0; --i) {
      if (state(i).waits_for == 0) make_ready(i);
    }
    while (const std::size_t points = longest_of_next_group()) form_group(points);
  }

 private:
  Index link_count() const { return static_cast<Index>(order_.links.size()); }
  LinkState& state(Index link) { return order_.states[link]; }
  ReadyLinks& ready(std::size_t points) { return order_.ready[points - 1]; }

  /// @pre done for all links after this one
  void tie_to_followers(Index i) {
    auto follower = state(i).followers.begin();
    for (const Index body : {order_.links[i].body_a, order_.links[i].body_b}) {
      if (body == no_index) continue;
      const Index next = std::exchange(order_.next_of_body[body], i);
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
    ContactGroup& group = order_.groups.emplace_back();
    for (const Index link : taken) {
      group.push_back(order_.links[link].contact);
      for (const Index follower : state(link).followers) {
        if (follower != no_index && --state(follower).waits_for == 0) make_ready(follower);
      }
    }
  }

  SolveOrder& order_;
};

void number_points(const PairList& pairs, SolveOrder& order) {
  order.first_point.resize(pairs.size() + 1);
  Index first = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    order.first_point[i] = first;
    first += pairs.summaries[i].points;
  }
  order.first_point.back() = first;
}

/// Contacts that link the neighbours of a row come last: those whose normals are across gravity, within 6° (the
/// cosine is 0.1). If each were visited between the contacts of its bodies with the next row, the rows would
/// become one chain of contacts that wait for each other.
void list_contacts(const PairList& pairs, const Vec3& gravity, SolveOrder& order) {
  const Real across = Real(0.1) * gravity.norm();
  order.contacts.clear();
  order.neighbours.clear();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!pairs.has_points(i)) continue;
    const Vec3& normal = pairs.contacts[i].manifold.normal;
    const bool links_neighbours = std::abs(normal.dot(gravity)) < across;
    (links_neighbours ? order.neighbours : order.contacts).push_back(static_cast<Index>(i));
  }
  order.contacts.insert(order.contacts.end(), order.neighbours.begin(), order.neighbours.end());
}

void list_links(const PairList& pairs, std::span<const RigidBody> bodies, SolveOrder& order) {
  const auto movable = [&](Index body) {
    return bodies[body].kind == BodyKind::Dynamic ? body : no_index;
  };
  order.links.clear();
  for (const Index i : order.contacts) {
    const PairSummary& pair = pairs.summaries[i];
    order.links.push_back({i, movable(pair.body_a), movable(pair.body_b), pair.points});
  }
}

}  // namespace

void arrange_constraints(const PairList& pairs, std::span<const RigidBody> bodies,
                         const Vec3& gravity, SolveOrder& order) {
  make_room(pairs.size(), order.contacts, order.neighbours, order.links, order.grouped,
            order.states);
  for (ReadyLinks& links : order.ready) make_room(pairs.size(), links.tops);
  number_points(pairs, order);
  list_contacts(pairs, gravity, order);
  list_links(pairs, bodies, order);
  if (order.links == order.grouped) return;  // most steps of a scene at rest
  Schedule(order, bodies.size()).run();
  std::swap(order.grouped, order.links);
  order.place_of_point.resize(order.first_point.back());
  const auto points_of = [&](Index i) { return pairs.summaries[i].points; };
  Index place = 0;
  // The longest contacts of a group come first, so those that have points left are always the first ones.
  for (const ContactGroup& group : order.groups) {
    for (Index point = 0; point < points_of(group[0]); ++point) {
      for (const Index contact : group) {
        if (point >= points_of(contact)) break;
        order.place_of_point[order.first_point[contact] + point] = place++;
      }
    }
  }
}

void keep_groups(const SolveOrder& order, ConstraintMirror& mirror) {
  mirror.starts.clear();
  for (const ContactGroup& group : order.groups) {
    mirror.starts.push_back(order.places_of(group[0])[0]);
  }
}

}  // namespace cs550
