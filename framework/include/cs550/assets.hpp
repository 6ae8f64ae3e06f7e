#pragma once
/// @file assets.hpp
/// Locates the shipped meshes and scenes.

#include <filesystem>

namespace cs550 {

/// The folder that contains meshes/ and scenes/: the value of the environment variable CS550_ASSETS
/// if it is set, otherwise the folder in the source tree that this program was built from.
std::filesystem::path assets_folder();

}  // namespace cs550
