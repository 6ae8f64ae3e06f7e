#pragma once
/// @file scene_cost.hpp
/// Refuses scenes that would fill the memory or take minutes to load, before the work is done.

#include <cstdint>
#include <filesystem>
#include <string>

#include "cs550/scene.hpp"

namespace cs550 {

/// What a scene needs, added up while it is read. Each function throws SceneFault at a JSON path if the scene
/// exceeds a limit with what is added: call it first, and then do the work.
class SceneCost {
 public:
  explicit SceneCost(const SceneLimits& limits) : limits_(limits) {}

  /// The text of a scene or of a mesh file, which becomes a tree of values.
  void add_file(const std::filesystem::path& file, const std::string& path);
  void add_bodies(std::int64_t count, const std::string& path);
  /// The points of one hull, or of one mesh file.
  void add_cloud(std::int64_t count, const std::string& path);
  /// Vertices of shapes.
  void add_points(std::int64_t count, const std::string& path);
  /// The pairs of bodies with overlapping bounds: each costs memory and time in every step. Counts no further
  /// than the body that exceeds the limit.
  void add_pairs(const Scene& scene);

 private:
  void add_memory(std::int64_t count, int bytes, const std::string& things,
                  const std::string& path);

  const SceneLimits& limits_;
  std::int64_t bodies_ = 0;
  std::int64_t points_ = 0;
  std::int64_t bytes_ = 0;
};

}  // namespace cs550
