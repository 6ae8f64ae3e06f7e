#pragma once
/// @file part_numbering.hpp
/// Bodies in the order of their parts.

#include "engine/world_state.hpp"

namespace cs550 {

/// While it lives, the bodies of the world are numbered part by part, so that each thread sweeps over
/// neighbours in memory. If threads took turns in an array, each would wait for cache lines of the other:
/// processors fetch the lines beside those that they need. See BodyParts::number_of().
///
/// Worlds with one thread, and those that a step treats body by body (checks, bounces, recovery from
/// overlap), keep their numbers.
class PartNumbering {
 public:
  /// @pre the solve order is that of this step's contacts
  explicit PartNumbering(WorldState& world);
  ~PartNumbering();
  PartNumbering(const PartNumbering&) = delete;
  PartNumbering& operator=(const PartNumbering&) = delete;

 private:
  WorldState& world_;
};

}  // namespace cs550
