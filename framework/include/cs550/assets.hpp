#pragma once
/// @file assets.hpp
/// Where meshes and scenes are.

#include <filesystem>

namespace cs550 {

/// The folder that holds meshes/ and scenes/: the environment variable CS550_ASSETS if it is set,
/// else the one in the source tree from which this was built.
std::filesystem::path assets_folder();

}  // namespace cs550
