#include "engine/parts/body_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "cs550/static_vector.hpp"

namespace cs550 {

namespace {

/// With fewer contacts, threads would wait for each other longer than they save.
constexpr Index fewest_contacts = 128;
/// How many steps the bodies keep their parts.
constexpr int steps_between_divisions = 16;
/// From here on, more than two threads have enough to do.
constexpr Index contacts_in_part = 2048;

Index part_count(Index contacts) {
  if (contacts < fewest_contacts) return 1;
  return std::clamp<Index>(contacts / contacts_in_part, 2, most_parts);
}

bool is_movable(const RigidBody& body) { return body.kind == BodyKind::Dynamic; }

/// Every direction reads all of them twice, so they are side by side in memory.
/// @param count of the contacts with points
void list_ends(const PairList& pairs, std::span<const RigidBody> bodies, std::size_t count,
               std::vector<ContactEnds>& ends) {
  ends.clear();
  if (ends.capacity() < count) ends.reserve(2 * count);  // a pile at rest has a few more or less
  for (const PairSummary& pair : pairs.summaries) {
    if (pair.points == 0) continue;
    const RigidBody& a = bodies[pair.body_a];
    const RigidBody& b = bodies[pair.body_b];
    ends.push_back({(is_movable(a) ? a : b).pose.position, (is_movable(b) ? b : a).pose.position});
  }
}

/// Slices of equal width, one behind the other in a direction. They reach from the first to the last body that has
/// contacts.
struct Slices {
  static constexpr int count = 128;

  Vec3 direction = Vec3::Zero();  ///< in the world frame
  Real start = 0;
  Real per_length = 0;

  /// Of a body. One outside is in the first or the last one.
  int of(const Vec3& position) const {
    const Real slice = (direction.dot(position) - start) * per_length;
    if (!(slice > 0)) return 0;  // or not a number
    return static_cast<int>(std::min(slice, static_cast<Real>(count - 1)));
  }
};

/// Of each slice.
struct Census {
  std::array<Index, Slices::count> up_to{};  ///< contacts in it and in those before it
  std::array<Index, Slices::count> cut{};    ///< contacts that a cut after it crosses
};

Census count_contacts(std::span<const ContactEnds> contacts, const Slices& slices) {
  Census census;
  for (const auto& [a, b] : contacts) {
    const auto [first, last] = std::minmax({slices.of(a), slices.of(b)});
    ++census.up_to[last];
    ++census.cut[first];
    --census.cut[last];
  }
  for (int i = 1; i < Slices::count; ++i) {
    census.up_to[i] += census.up_to[i - 1];
    census.cut[i] += census.cut[i - 1];
  }
  return census;
}

/// The slices with which the parts end.
struct Cuts {
  Slices slices;
  std::array<int, most_parts> last_slice{};
  Index cost = 0;  ///< see cost_of_cut()

  Index part_of(const RigidBody& body, Index parts) const {
    const int slice = slices.of(body.pose.position);
    Index part = 0;
    while (part + 1 < parts && slice > last_slice[part]) ++part;
    return part;
  }
};

/// The contacts that a thread waits for if a part ends with a slice: those by which the parts up to it, or those after
/// it, exceed their share, and those between them. The latter count twice, since their bodies have to be fetched from
/// another core.
Index cost_of_cut(const Census& census, int slice, Index wanted) {
  const Index cut = census.cut[slice];
  return std::abs(census.up_to[slice] + cut / 2 - wanted) + 2 * cut;
}

Cuts cuts_across(const Slices& slices, std::span<const ContactEnds> contacts, Index parts) {
  Cuts cuts{slices};
  const Census census = count_contacts(contacts, slices);
  for (Index part = 0; part + 1 < parts; ++part) {
    const Index wanted = census.up_to.back() * (part + 1) / parts;
    const auto cost = [&](int slice) { return cost_of_cut(census, slice, wanted); };
    int best = 0;
    for (int slice = 1; slice < Slices::count; ++slice) {
      if (cost(slice) < cost(best)) best = slice;
    }
    cuts.last_slice[part] = best;
    cuts.cost += cost(best);
  }
  return cuts;
}

Slices slices_along(const Vec3& direction, std::span<const ContactEnds> contacts) {
  Real first = HUGE_VALF;
  Real last = -first;
  for (const auto& [a, b] : contacts) {
    const auto [from, to] = std::minmax({direction.dot(a), direction.dot(b)});
    first = std::min(first, from);
    last = std::max(last, to);
  }
  const Real extent = last - first;
  return {direction, first, extent > 0 ? static_cast<Real>(Slices::count) / extent : 0};
}

constexpr std::size_t most_directions = 9;

/// The directions in which parts may follow each other: along the axes, other than the one nearest to gravity, since
/// bodies stay with what they rest on; and slightly oblique to them. A cut across x between five by five towers leaves
/// ten on one side, an oblique one twelve.
StaticVector<Vec3, most_directions> directions_across(const Vec3& gravity) {
  StaticVector<Vec3, most_directions> directions;
  int down = 0;
  const bool weighs = gravity.cwiseAbs().maxCoeff(&down) > 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (weighs && axis == down) continue;
    const int next = (axis + 1) % 3;
    const int other = weighs && next == down ? (axis + 2) % 3 : next;
    for (const Real slope : {Real(0), Real(0.125), Real(-0.125)}) {
      directions.push_back(Vec3::Unit(axis) + slope * Vec3::Unit(other));
    }
  }
  return directions;
}

/// Those across a direction. If the contacts have no extent in it, all bodies are in one part.
Cuts cuts_along(const Vec3& direction, std::span<const ContactEnds> contacts, Index parts) {
  const Slices slices = slices_along(direction, contacts);
  if (slices.per_length > 0) return cuts_across(slices, contacts, parts);
  Cuts none;
  none.cost = std::numeric_limits<Index>::max();
  return none;
}

/// Those along the direction in which they are cheapest.
Cuts best_cuts(std::span<const ContactEnds> contacts, const Vec3& gravity, Index parts,
               ThreadTeam* team) {
  const auto directions = directions_across(gravity);
  std::array<Cuts, most_directions> cuts;
  const auto count = static_cast<std::size_t>(directions.size());
  for_blocks(team, count, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      cuts[i] = cuts_along(directions[static_cast<int>(i)], contacts, parts);
    }
  });
  return *std::min_element(cuts.begin(), cuts.begin() + count,
                           [](const Cuts& a, const Cuts& b) { return a.cost < b.cost; });
}

}  // namespace

void divide_bodies(const PairList& pairs, std::span<const RigidBody> bodies, const Vec3& gravity,
                   BodyParts& parts, ThreadTeam* team) {
  parts.of_body.resize(bodies.size(), 0);
  if (parts.count > 1 && ++parts.age < steps_between_divisions) return;
  parts.age = 0;
  parts.numbers.clear();
  const auto contacts = std::count_if(pairs.summaries.begin(), pairs.summaries.end(),
                                      [](const PairSummary& pair) { return pair.points > 0; });
  parts.count = part_count(static_cast<Index>(contacts));
  parts.of_body.assign(bodies.size(), 0);
  if (parts.count == 1) return;
  list_ends(pairs, bodies, static_cast<std::size_t>(contacts), parts.contacts);
  const Cuts cuts = best_cuts(parts.contacts, gravity, parts.count, team);
  parts.direction = cuts.slices.direction;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    parts.of_body[i] = cuts.part_of(bodies[i], parts.count);
  }
}

}  // namespace cs550
