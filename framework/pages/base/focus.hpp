#pragma once
/// @file focus.hpp
/// Where the action is.

#include "cs550/math.hpp"

namespace cs550::pages {

/// The ball that matters: the camera frames it, shadows are sharp in it, and far outside of it the
/// ground fades.
struct Focus {
  Vec3 center = Vec3::Zero();  ///< m
  Real radius = 1;             ///< m

  bool operator==(const Focus& other) const {
    return center == other.center && radius == other.radius;
  }
};

/// The ball around a box. @param bounds not empty
inline Focus focus_of(const Bounds& bounds) {
  return {bounds.center(), Real(0.5) * bounds.extent().norm()};
}

}  // namespace cs550::pages
