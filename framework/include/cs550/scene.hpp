#pragma once
/// @file scene.hpp
/// Worlds described in JSON files.

#include <filesystem>
#include <string>
#include <vector>

#include "cs550/world.hpp"

namespace cs550 {

/// A scene file, read: everything that is needed to build its world, any number of times.
struct Scene {
  std::string name;                     ///< of the file, without its ending
  std::string title;                    ///< one line for people
  std::string description;              ///< some sentences for people
  WorldSettings settings;               ///< of its world
  std::vector<BodyDef> bodies;          ///< in the order of the file, generators run
  std::vector<std::string> body_names;  ///< parallel to bodies; may be empty strings
  Real h = Real(1) / 60;                ///< step (s)
  int steps = 600;                      ///< how long a demo runs
  Real max_penetration = 0;             ///< stated bound on penetration, tested (m)
};

/// A scene, or a sentence: file, JSON path, what was expected, an example.
struct SceneResult {
  Scene scene;        ///< empty if there is an error
  std::string error;  ///< empty if there is a scene

  /// Whether there is a scene.
  explicit operator bool() const { return error.empty(); }
};

/// Reads a scene file (schema version 1, framework/assets/scenes/README.md). Meshes are looked for
/// beside the scene and in the assets' meshes/ folder.
SceneResult load_scene(const std::filesystem::path& file);

/// The shipped scene of that name ("wall"), or a sentence that lists the names there are; also takes
/// a path.
SceneResult find_scene(const std::string& name_or_path);

/// The names of the shipped scenes, sorted.
std::vector<std::string> shipped_scenes();

/// A world with the bodies of a scene, at its time 0.
World make_world(const Scene& scene);

}  // namespace cs550
