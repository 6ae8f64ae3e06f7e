#pragma once
/// @file focus.hpp
/// The part of a scene that matters.

#include "cs550/math.hpp"

namespace cs550::pages {

/// A ball around the part that matters. The camera frames it, shadows inside it are sharp, and the
/// ground fades far outside of it.
struct Focus {
  Vec3 center = Vec3::Zero();  ///< m
  Real radius = 1;             ///< m

  bool operator==(const Focus& other) const {
    return center == other.center && radius == other.radius;
  }
};

/// The ball around a box. @pre bounds is not empty
inline Focus focus_of(const Bounds& bounds) {
  return {bounds.center(), Real(0.5) * bounds.extent().norm()};
}

}  // namespace cs550::pages
