#include "engine/contacts/solve_order.hpp"

#include <algorithm>
#include <cmath>

namespace cs550 {

namespace {

Index point_count(const Contact& contact) { return contact.manifold.points.size(); }

/// Puts every contact into the first group that comes after those of both its bodies (list
/// scheduling), has room, and does not become longer: a lane that has run out of points idles.
class Grouping {
 public:
  Grouping(std::span<const Contact> contacts, std::vector<ContactGroup>& groups)
      : contacts_(contacts), groups_(groups) {
    groups_.clear();
  }

  /// @param earliest the first group after those of the contact's bodies
  Index place(Index contact, Index earliest) {
    Index group = std::max(earliest, first_open_);
    while (group < count() && !takes(at(group), contact)) ++group;
    if (group == count()) groups_.emplace_back();
    at(group).push_back(contact);
    while (first_open_ < count() && at(first_open_).full()) ++first_open_;
    return group;
  }

 private:
  Index count() const { return static_cast<Index>(groups_.size()); }
  ContactGroup& at(Index group) { return groups_[group]; }
  Index points_of(Index contact) const { return point_count(contacts_[contact]); }
  bool takes(const ContactGroup& group, Index contact) const {
    return !group.full() && points_of(contact) <= points_of(group[0]);
  }

  std::span<const Contact> contacts_;
  std::vector<ContactGroup>& groups_;
  Index first_open_ = 0;
};

void find_groups(std::span<const Contact> contacts, std::span<const RigidBody> bodies,
                 SolveOrder& order) {
  Grouping grouping(contacts, order.groups);
  order.group_after_body.assign(bodies.size(), 0);
  for (const Index i : order.contacts) {
    const Index a = contacts[i].body_a;
    const Index b = contacts[i].body_b;
    const Index earliest = std::max(order.group_after_body[a], order.group_after_body[b]);
    const Index group = grouping.place(i, earliest);
    if (bodies[a].kind == BodyKind::Dynamic) order.group_after_body[a] = group + 1;
    if (bodies[b].kind == BodyKind::Dynamic) order.group_after_body[b] = group + 1;
  }
}

void number_points(std::span<const Contact> contacts, SolveOrder& order) {
  order.first_point.assign(1, 0);
  for (const Contact& contact : contacts) {
    order.first_point.push_back(order.first_point.back() + point_count(contact));
  }
}

/// Whether the normal is across gravity: within 6° (the cosine is 0.1).
bool links_neighbours(const Contact& contact, const Vec3& gravity) {
  return std::abs(contact.manifold.normal.dot(gravity)) < Real(0.1) * gravity.norm();
}

/// Contacts that link the neighbours of a row come last. If each were visited between the contacts of its bodies
/// with the next row, the rows would become one chain of contacts that wait for each other.
void list_contacts(std::span<const Contact> contacts, const Vec3& gravity, SolveOrder& order) {
  order.contacts.clear();
  for (const bool neighbours : {false, true}) {
    for (Index i = 0; i < static_cast<Index>(contacts.size()); ++i) {
      if (point_count(contacts[i]) > 0 && links_neighbours(contacts[i], gravity) == neighbours) {
        order.contacts.push_back(i);
      }
    }
  }
}

}  // namespace

void arrange_constraints(std::span<const Contact> contacts, std::span<const RigidBody> bodies,
                         const Vec3& gravity, SolveOrder& order) {
  number_points(contacts, order);
  list_contacts(contacts, gravity, order);
  find_groups(contacts, bodies, order);
  order.place_of_point.resize(order.first_point.back());
  const auto points_of = [&](Index i) { return point_count(contacts[i]); };
  Index place = 0;
  for (ContactGroup& group : order.groups) {
    // Longest first: the contacts that have points left are then always the first ones.
    std::sort(group.begin(), group.end(), [&](Index i, Index k) {
      return points_of(i) != points_of(k) ? points_of(i) > points_of(k) : i < k;
    });
    for (Index point = 0; point < points_of(group[0]); ++point) {
      for (const Index contact : group) {
        if (point >= points_of(contact)) break;
        order.place_of_point[order.first_point[contact] + point] = place++;
      }
    }
  }
}

}  // namespace cs550
