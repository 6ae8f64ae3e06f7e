#include "engine/contacts/solve_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

#include "engine/contacts/link_schedule.hpp"
#include "engine/contacts/row_order.hpp"

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

/// Numbers the points, and lists the contacts that have any.
void number_points(const PairList& pairs, SolveOrder& order) {
  order.first_point.resize(pairs.size() + 1);
  order.with_points.resize(pairs.size());
  Index first = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Index points = pairs.summaries[i].points;
    order.first_point[i] = first;
    // The next contact replaces this one unless it counts. A branch would often be mispredicted.
    order.with_points[count] = static_cast<Index>(i);
    count += static_cast<std::size_t>(points > 0);
    first += points;
  }
  order.first_point.back() = first;
  order.with_points.resize(count);
}

/// The unit of a contact between bodies of these parts.
Index unit_between(Index part_a, Index part_b, Index parts) {
  if (part_a == part_b) return part_a;
  if (std::abs(part_a - part_b) > 1) return 2 * parts - 1;
  const Index lower = std::min(part_a, part_b);
  return parts + lower / 2 + (lower % 2 == 1 ? parts / 2 : 0);
}

/// Ranks of a unit: those of its contacts that carry weight, and then as many of the others.
constexpr Index colour_count = 4;
constexpr Index ranks_of_unit = 2 * colour_count;

/// Finds what the links tie together, and their ranks. Within a unit, contacts that link the neighbours of a
/// row come last: those whose normals are across gravity, within 6° (the cosine is 0.1). If each were visited
/// between the contacts of its bodies with the next row, the rows would become one chain of contacts that wait
/// for each other.
void tie_links(const PairList& pairs, std::span<const RigidBody> bodies, const Vec3& gravity,
               const BodyParts& parts, SolveOrder& order, ThreadTeam* team) {
  const Real across = Real(0.1) * gravity.norm();
  const auto movable = [&](Index body) {
    return bodies[body].kind == BodyKind::Dynamic ? body : no_index;
  };
  const auto part_of = [&](Index body, Index other) {
    return parts.count == 1 ? 0 : parts.of_body[body != no_index ? body : other];
  };
  const auto link_of = [&](Index contact) {
    const PairSummary& pair = pairs.summaries[contact];
    const Index a = movable(pair.body_a);
    const Index b = movable(pair.body_b);
    const Index unit = unit_between(part_of(a, b), part_of(b, a), parts.count);
    return ContactLink{contact, a, b, pair.points, unit};
  };
  const auto rank_of = [&](const ContactLink& link) {
    const Vec3& normal = pairs.contacts[link.contact].manifold.normal;
    const bool links_neighbours = std::abs(normal.dot(gravity)) < across;
    return ranks_of_unit * link.unit + (links_neighbours ? colour_count : 0);
  };
  RankedLinks& unsorted = order.unsorted;
  unsorted.parts = parts.count;
  unsorted.links.resize(order.with_points.size());
  unsorted.ranks.resize(order.with_points.size());
  constexpr std::size_t block = 32;
  for_blocks(team, order.with_points.size(), block, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      unsorted.links[i] = link_of(order.with_points[i]);
      unsorted.ranks[i] = rank_of(unsorted.links[i]);
    }
  });
}

/// Moves links between parts to ranks in which no two share a body. In their own order, those of a pyramid's
/// parts would be one chain, and all threads but one would wait for it.
void colour_links_between_parts(Index parts, std::size_t bodies, SolveOrder& order) {
  order.ranks = order.unsorted.ranks;
  if (parts == 1) return;
  order.colours_of_body.assign(bodies, 0);
  for (std::size_t i = 0; i < order.ranks.size(); ++i) {
    const ContactLink& link = order.unsorted.links[i];
    if (link.unit < parts) continue;
    unsigned& of_a = order.colours_of_body[link.body_a];
    unsigned& of_b = order.colours_of_body[link.body_b];
    const Index colour = std::min<Index>(std::countr_one(of_a | of_b), colour_count - 1);
    of_a |= 1U << colour;
    of_b |= 1U << colour;
    order.ranks[i] += colour;
  }
}

/// Sorts the links by rank, and notes where the units begin.
void sort_links(SolveOrder& order) {
  std::array<Index, ranks_of_unit * most_units + 1> next{};
  for (const Index rank : order.ranks) ++next[rank + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::size_t i = 0; i < order.units.size(); ++i) {
    order.units[i].first_contact = next[ranks_of_unit * i];
    order.units[i].first_across = next[ranks_of_unit * i + colour_count];
    order.units[i].end_contact = next[ranks_of_unit * (i + 1)];
  }
  order.links.resize(order.ranks.size());
  for (std::size_t i = 0; i < order.ranks.size(); ++i) {
    order.links[next[order.ranks[i]]++] = order.unsorted.links[i];
  }
  std::swap(order.unsorted, order.sorted_from);
}

void list_contacts(SolveOrder& order) {
  order.contacts.resize(order.links.size());
  std::transform(order.links.begin(), order.links.end(), order.contacts.begin(),
                 [](const ContactLink& link) { return link.contact; });
}

/// The units of several threads.
void make_units(Index parts, SolveOrder& order) {
  const Index in_phase[] = {parts, parts / 2, (parts - 1) / 2, parts > 1 ? 1 : 0};
  for (std::size_t i = 0; i < phase_count; ++i) {
    order.phases[i + 1] = order.phases[i] + static_cast<std::size_t>(in_phase[i]);
  }
  order.units.resize(order.phases.back());
}

/// Whether links and units are those of the last step, as in most steps of a scene at rest.
bool are_sorted(const SolveOrder& order, Index parts, const ThreadTeam* team) {
  const Index units = team == nullptr || parts == 1 ? 1 : 2 * parts;
  return order.units.size() == static_cast<std::size_t>(units) &&
         order.unsorted == order.sorted_from;
}

/// One thread takes all contacts as a unit: their order is the same, and more of them are side by side.
void unite(SolveOrder& order) {
  order.phases.fill(1);
  order.phases[0] = 0;
  order.units.resize(1);
  order.units[0].first_contact = 0;
  order.units[0].end_contact = static_cast<Index>(order.links.size());
  for (ContactLink& link : order.links) link.unit = 0;
}

/// The longest contacts of a group come first, so those that have points left are always the first ones.
void place_points(const PairList& pairs, SolveOrder& order, SolveUnit& unit) {
  const auto points_of = [&](Index i) { return pairs.summaries[i].points; };
  Index place = unit.first_place;
  for (const ContactGroup& group : unit.groups) {
    for (Index point = 0; point < points_of(group[0]); ++point) {
      for (const Index contact : group) {
        if (point >= points_of(contact)) break;
        order.place_of_point[order.first_point[contact] + point] = place++;
      }
    }
  }
}

void place_units(SolveOrder& order) {
  Index place = 0;
  for (SolveUnit& unit : order.units) {
    unit.first_place = place;
    for (Index i = unit.first_contact; i < unit.end_contact; ++i) place += order.links[i].points;
    unit.end_place = place;
  }
  order.place_of_point.resize(order.first_point.back());
}

}  // namespace

void arrange_constraints(const PairList& pairs, std::span<const RigidBody> bodies,
                         const Vec3& gravity, SolveOrder& order, const BodyParts& parts,
                         ThreadTeam* team) {
  make_room(pairs.size(), order.contacts, order.unsorted.links, order.unsorted.ranks,
            order.sorted_from.links, order.sorted_from.ranks, order.links, order.ranks,
            order.with_points, order.states);
  make_room(pairs.size() / 3, order.rows);  // of three links or more
  number_points(pairs, order);
  tie_links(pairs, bodies, gravity, parts, order, team);
  const bool sorted = are_sorted(order, parts.count, team);
  if (!sorted) {
    make_units(parts.count, order);
    colour_links_between_parts(parts.count, bodies.size(), order);
    sort_links(order);
    find_rows(parts, order);
  }
  const bool turned = turn_rows_outwards(bodies, parts, order);
  if (sorted && !turned) return;
  list_contacts(order);
  if (team == nullptr) unite(order);
  order.states.resize(order.links.size());
  for_units(team, order, [&](std::size_t i) { form_groups(order, order.units[i], bodies.size()); });
  place_units(order);
  for_units(team, order, [&](std::size_t i) { place_points(pairs, order, order.units[i]); });
}

void keep_groups(const SolveOrder& order, ConstraintMirrors& mirrors, ThreadTeam* team) {
  mirrors.of_units.resize(order.units.size());
  for_units(team, order, [&](std::size_t i) {
    const SolveUnit& unit = order.units[i];
    std::vector<Index>& starts = mirrors.of_units[i].starts;
    starts.clear();
    for (const ContactGroup& group : unit.groups) {
      starts.push_back(order.places_of(group[0])[0] - unit.first_place);
    }
  });
  mirrors.set_stale();
}

}  // namespace cs550
