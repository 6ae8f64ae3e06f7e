#pragma once
/// @file pairs_of_contacts.hpp
/// A list of pairs for functions that look at nothing but its contacts.

#include <span>

#include "engine/world_state.hpp"

namespace cs550::test {

inline PairList pairs_of(std::span<const Contact> contacts) {
  PairList pairs;
  for (const Contact& contact : contacts) pairs.append(contact);
  return pairs;
}

}  // namespace cs550::test
