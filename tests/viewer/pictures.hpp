#pragma once
/// @file pictures.hpp
/// Compares pictures.

#include <array>
#include <filesystem>

#include "viewer/picture.hpp"

namespace cs550::test {

using viewer::Picture;

/// Reads a PNG file. @throws std::runtime_error if it is none
Picture read_png(const std::filesystem::path& file);

/// The picture at half the width and height. Each pixel is the mean of four.
Picture halved(const Picture& picture);

/// The share of pixels with a channel that differs by more than 2 %, or 1 if the sizes differ.
double share_that_differs(const Picture& a, const Picture& b);

/// The share of pixels within 12 % of a colour. @param colour red, green, blue, 0–255
double share_of_colour(const Picture& picture, const std::array<int, 3>& colour);

/// The number of different colours, in steps of a sixteenth. A blank picture has few.
int colour_count(const Picture& picture);

}  // namespace cs550::test
