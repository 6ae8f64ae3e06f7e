#pragma once
/// @file snapshot.hpp
/// Pictures without a window.

#include "viewer/options.hpp"
#include "viewer/picture.hpp"

namespace cs550::viewer {

/// The picture described by the options. Needs a current OpenGL context.
/// @throws std::invalid_argument for a setting that does not exist
Picture take_picture(const Options& options);

/// Writes all files that the options request and prints their names.
/// @throws std::runtime_error if a file cannot be written, std::invalid_argument for a wrong option
void write_pictures(const Options& options);

}  // namespace cs550::viewer
