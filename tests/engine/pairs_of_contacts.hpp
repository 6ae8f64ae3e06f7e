#pragma once
/// @file pairs_of_contacts.hpp
/// A list of pairs for functions that look at nothing but its contacts.

#include <span>

#include "engine/pairs/pair_list.hpp"

namespace cs550::test {

inline PairList pairs_of(std::span<const Contact> contacts) {
  PairList pairs;
  PairListEdit edit(pairs);
  for (const Contact& contact : contacts) {
    edit.insert(0, pair_key(contact.body_a, contact.body_b));
  }
  edit.apply();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    pairs.contacts[i] = contacts[i];
    pairs.summaries[i] = {contacts[i].body_a, contacts[i].body_b};
    pairs.summarise(i);
  }
  return pairs;
}

}  // namespace cs550::test
