#pragma once
/// @file relative_pose.hpp
/// Where a body is, seen from another.

#include "cs550/math.hpp"

namespace cs550 {

/// The pose of a body in the frame of an observer. Far from the world's origin the difference of the
/// positions is exact, so only the distance between the bodies matters.
inline Pose seen_from(const Pose& observer, const Pose& body) {
  const Quat to_observer = observer.orientation.conjugate();
  return {to_observer * (body.position - observer.position), to_observer * body.orientation};
}

}  // namespace cs550
