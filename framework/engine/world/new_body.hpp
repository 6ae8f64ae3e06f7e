#pragma once
/// @file new_body.hpp
/// A body from its definition.

#include "cs550/world.hpp"

namespace cs550 {

/// @throws std::invalid_argument for a definition without a shape, or with a number that is not finite, has no
///         physical meaning, or would overflow; the message names it
RigidBody make_body(const BodyDef& def);

}  // namespace cs550
