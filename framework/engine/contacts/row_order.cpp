#include "engine/contacts/row_order.hpp"

#include <algorithm>

namespace cs550 {

namespace {

/// Two contacts share one body, so they have no direction.
constexpr std::size_t fewest_in_row = 3;

/// The movable body that is the first of two contacts, or the second of both; or no_index.
Index shared_body(const ContactLink& link, const ContactLink& next) {
  if (link.body_a == next.body_a && link.body_a != no_index) return link.body_a;
  return link.body_b == next.body_b ? link.body_b : no_index;
}

/// The number of links in the zigzag with which these begin.
std::size_t length_of_first_row(std::span<const ContactLink> links) {
  std::size_t count = 1;
  Index last = no_index;
  for (; count < links.size(); ++count) {
    const Index shared = shared_body(links[count - 1], links[count]);
    if (shared == no_index || shared == last) break;
    last = shared;
  }
  return count;
}

/// From the first to the last body that two contacts of the row share.
Vec3 extent(std::span<const ContactLink> row, std::span<const RigidBody> bodies) {
  const Index first = shared_body(row[0], row[1]);
  const Index last = shared_body(row[row.size() - 2], row[row.size() - 1]);
  return bodies[last].pose.position - bodies[first].pose.position;
}

/// Whether a row was sorted from the outside inwards. @param extent of the row as it lies
bool was_sorted_inwards(const LinkRow& row, const Vec3& extent, const Vec3& outwards) {
  const Real length_outwards = extent.dot(outwards);
  return row.turned ? length_outwards > 0 : length_outwards < 0;
}

}  // namespace

void find_rows(const BodyParts& parts, SolveOrder& order) {
  order.rows.clear();
  if (parts.count == 1) return;
  for (Index part = 0; part < parts.count; ++part) {
    const auto end = static_cast<std::size_t>(order.units[part].first_across);
    auto first = static_cast<std::size_t>(order.units[part].first_contact);
    while (first < end) {
      const std::size_t count =
          length_of_first_row(std::span(order.links).subspan(first, end - first));
      if (count >= fewest_in_row) order.rows.push_back({first, count, part});
      first += count;
    }
  }
}

bool turn_rows_outwards(std::span<const RigidBody> bodies, const BodyParts& parts,
                        SolveOrder& order) {
  bool any = false;
  for (LinkRow& row : order.rows) {
    const Vec3 outwards = row.part < parts.count / 2 ? -parts.direction : parts.direction;
    const auto links = std::span(order.links).subspan(row.first, row.count);
    if (was_sorted_inwards(row, extent(links, bodies), outwards) == row.turned) continue;
    std::reverse(links.begin(), links.end());
    row.turned = !row.turned;
    any = true;
  }
  return any;
}

}  // namespace cs550
