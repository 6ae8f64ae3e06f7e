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

/// The zigzag with which the links begin.
std::span<ContactLink> first_row(std::span<ContactLink> links) {
  std::size_t count = 1;
  Index last = no_index;
  for (; count < links.size(); ++count) {
    const Index shared = shared_body(links[count - 1], links[count]);
    if (shared == no_index || shared == last) break;
    last = shared;
  }
  return links.first(count);
}

/// From the first to the last body that two contacts of the row share.
Vec3 extent(std::span<const ContactLink> row, std::span<const RigidBody> bodies) {
  const Index first = shared_body(row[0], row[1]);
  const Index last = shared_body(row[row.size() - 2], row[row.size() - 1]);
  return bodies[last].pose.position - bodies[first].pose.position;
}

}  // namespace

void turn_rows_outwards(std::span<const RigidBody> bodies, const BodyParts& parts,
                        SolveOrder& order) {
  if (parts.count == 1) return;
  for (Index part = 0; part < parts.count; ++part) {
    const SolveUnit& unit = order.units[part];
    const Vec3 outwards = part < parts.count / 2 ? -parts.direction : parts.direction;
    std::span rest =
        std::span(order.links).subspan(unit.first_contact, unit.first_across - unit.first_contact);
    while (!rest.empty()) {
      const std::span<ContactLink> row = first_row(rest);
      rest = rest.subspan(row.size());
      if (row.size() < fewest_in_row) continue;
      if (extent(row, bodies).dot(outwards) < 0) std::reverse(row.begin(), row.end());
    }
  }
}

}  // namespace cs550
