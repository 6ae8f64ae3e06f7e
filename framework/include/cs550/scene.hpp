#pragma once
/// @file scene.hpp
/// Worlds described in JSON files.

#include <filesystem>
#include <string>
#include <vector>

#include "cs550/world.hpp"

namespace cs550 {

/// The contents of a scene file. Any number of worlds can be made from it.
struct Scene {
  std::string name;                     ///< file name without extension
  std::string title;                    ///< one line, for display
  std::string description;              ///< a few sentences, for display
  WorldSettings settings;               ///< of the world
  std::vector<BodyDef> bodies;          ///< in file order, with generators expanded
  std::vector<std::string> body_names;  ///< parallel to bodies; unnamed bodies have an empty string
  Real h = Real(1) / 60;                ///< step (s)
  int steps = 600;                      ///< length of a demo
  Real max_penetration = 0;             ///< bound on penetration, checked by tests (m)
};

/// Limits on the size of a scene. They are checked before the work that they bound, so that a
/// typing error in a generator is rejected at once.
struct SceneLimits {
  int bodies = 50000;         ///< of the whole scene
  int hull_points = 20000;    ///< of one point cloud or mesh file
  int total_points = 500000;  ///< vertices of all shapes of the scene
  int pairs = 100000;         ///< of bodies with overlapping bounds at time 0
  int memory_mb = 2048;       ///< estimated for files, bodies, vertices and pairs
  std::string fault = {};  ///< of an environment variable that is no limit; empty if there is none

  /// The defaults, each replaced by an environment variable if it is set: CS550_MAX_BODIES,
  /// CS550_MAX_HULL_POINTS, CS550_MAX_TOTAL_POINTS, CS550_MAX_PAIRS, CS550_MAX_MEMORY_MB.
  static SceneLimits from_environment();
};

/// A scene, or an error message with file, JSON path, expected value and an example.
struct SceneResult {
  Scene scene;        ///< empty on error
  std::string error;  ///< empty on success
  /// The step of the lab that makes shapes, "L2.1", if the error is that it is not written.
  std::string missing_step = {};

  /// Whether there is a scene.
  explicit operator bool() const { return error.empty(); }
};

/// Reads a scene file (schema version 1, framework/assets/scenes/README.md). Meshes are looked up
/// beside the scene and in the folder meshes/ of the assets.
SceneResult load_scene(const std::filesystem::path& file,
                       const SceneLimits& limits = SceneLimits::from_environment());

/// Loads a shipped scene by its name ("wall") or any scene by its path. The error for an unknown
/// name lists the shipped scenes.
SceneResult find_scene(const std::string& name_or_path);

/// Why there is no such scene, with a list of those that are shipped; empty if there is one.
/// Nothing is loaded.
std::string fault_of_scene_name(const std::string& name_or_path);

/// The names of the shipped scenes, sorted.
std::vector<std::string> shipped_scenes();

/// A world with the bodies of a scene, at time 0. Body i of the scene is World::id_at(i).
World make_world(const Scene& scene);

}  // namespace cs550
