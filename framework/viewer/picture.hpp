#pragma once
/// @file picture.hpp
/// Pixels, and PNG files of them.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "viewer/gl/canvas.hpp"

namespace cs550::viewer {

/// Red, green and blue, a byte each, from the top left, row by row.
struct Picture {
  Size size;                         ///< pixels
  std::vector<std::uint8_t> pixels;  ///< 3 · width · height
};

/// The present contents of a canvas.
Picture read_picture(const Canvas& canvas);

/// Writes a PNG file and creates its folders. An existing file is replaced atomically.
/// @throws std::runtime_error that names the file
void write_png(const Picture& picture, const std::filesystem::path& file);

}  // namespace cs550::viewer
