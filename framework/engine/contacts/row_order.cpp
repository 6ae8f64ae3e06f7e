#include "engine/contacts/row_order.hpp"

#include <algorithm>

namespace cs550 {

namespace {

/// Fewer contacts are not a row: piles have many pairs of contacts on one body.
constexpr std::size_t fewest_in_row = 3;

enum class SharedBody { None, First, Second };

/// The movable body that two contacts have in common, if it is the first of both or the second of both.
SharedBody shared_body(const ContactLink& link, const ContactLink& next) {
  if (link.body_a == next.body_a && link.body_a != no_index) return SharedBody::First;
  if (link.body_b == next.body_b && link.body_b != no_index) return SharedBody::Second;
  return SharedBody::None;
}

/// The zigzag with which the links begin.
std::span<ContactLink> first_row(std::span<ContactLink> links) {
  std::size_t count = 1;
  SharedBody last = SharedBody::None;
  for (; count < links.size(); ++count) {
    const SharedBody shared = shared_body(links[count - 1], links[count]);
    if (shared == SharedBody::None || shared == last) break;
    last = shared;
  }
  return links.first(count);
}

const Vec3& position(std::span<const RigidBody> bodies, const ContactLink& link) {
  return bodies[link.body_a != no_index ? link.body_a : link.body_b].pose.position;
}

}  // namespace

void turn_rows_outwards(std::span<const RigidBody> bodies, const BodyParts& parts,
                        SolveOrder& order) {
  if (parts.count == 1) return;
  for (Index part = 0; part < parts.count; ++part) {
    const SolveUnit& unit = order.units[part];
    const Vec3 outwards = part < parts.count / 2 ? -parts.direction : parts.direction;
    std::span rest =
        std::span(order.links).subspan(unit.first_contact, unit.end_contact - unit.first_contact);
    while (!rest.empty()) {
      const std::span<ContactLink> row = first_row(rest);
      rest = rest.subspan(row.size());
      if (row.size() < fewest_in_row) continue;
      const Vec3 along = position(bodies, row.back()) - position(bodies, row.front());
      if (along.dot(outwards) < 0) std::reverse(row.begin(), row.end());
    }
  }
}

}  // namespace cs550
