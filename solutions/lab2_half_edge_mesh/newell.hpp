#pragma once
/// @file newell.hpp
/// What the two files of this solution share. Not in namespace cs550: what a lab defines there is
/// what students have to write.

#include <vector>

#include "cs550/math.hpp"

namespace lab2 {

/// The plane of a polygon by Newell's method, through the centroid of its corners.
/// @param polygon corners, counter-clockwise, any frame (m)
cs550::Plane newell_plane(const std::vector<cs550::Vec3>& polygon);

}  // namespace lab2
