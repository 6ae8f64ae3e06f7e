#pragma once
/// @file pictures.hpp
/// Pictures that are compared.

#include <array>
#include <filesystem>

#include "viewer/picture.hpp"

namespace cs550::test {

using viewer::Picture;

/// @throws std::runtime_error if it is not a PNG file
Picture read_png(const std::filesystem::path& file);

/// Half as wide and high; each pixel is the mean of four.
Picture halved(const Picture& picture);

/// The share of pixels of which a channel differs by more than 2 %; 1 for other sizes.
double share_that_differs(const Picture& a, const Picture& b);

/// The share of pixels within 12 % of a colour. @param colour red, green, blue, 0–255
double share_of_colour(const Picture& picture, const std::array<int, 3>& colour);

/// How many different colours there are, in steps of a sixteenth: a blank picture has few.
int colour_count(const Picture& picture);

}  // namespace cs550::test
