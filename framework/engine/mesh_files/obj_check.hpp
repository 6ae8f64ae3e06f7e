#pragma once
/// @file obj_check.hpp
/// Lines of an OBJ file that its parser would misread without a word.

#include <istream>
#include <string>

namespace cs550 {

/// The first line with a coordinate that is not a finite number ("1,5", "nan"), a face with fewer than 3
/// or more than max_obj_face_corners corners, a vertex number that no vertex has, or a control character; or a
/// face of more than three corners whose vertices come after the next "g" or "o", or after "mtllib" the next
/// "usemtl", in the first such group.
/// @param text without comments
/// @returns a sentence with the number of the line; empty if there is no such line
std::string first_obj_fault(std::istream& text);

/// Larger polygons take the parser minutes to split.
inline constexpr int max_obj_face_corners = 1000;

}  // namespace cs550
