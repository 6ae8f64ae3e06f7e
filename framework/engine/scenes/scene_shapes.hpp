#pragma once
/// @file scene_shapes.hpp
/// The shapes of a scene file.

#include <filesystem>
#include <map>
#include <string>

#include "cs550/convex_shape.hpp"
#include "cs550/primitives.hpp"
#include "cs550/scene.hpp"
#include "engine/scenes/scene_cost.hpp"
#include "engine/scenes/scene_reader.hpp"

namespace cs550 {

inline constexpr int box_vertices = 8;

/// Makes shapes as objects describe them, and keeps those that the scene gives a name.
class SceneShapes {
 public:
  /// @param scene_folder where mesh files are looked for first
  /// @param cost to which the vertices of each shape are added
  SceneShapes(std::filesystem::path scene_folder, SceneCost& cost)
      : folder_(std::move(scene_folder)), cost_(cost) {}

  /// Reads the named shapes of the scene: {"brick": {...}, ...}.
  void define(SceneReader named);

  /// The shape under a key: an object, or the name of a shape.
  ShapePtr read(SceneReader& owner, const std::string& key) const;

  /// The hull of so many points on an ellipsoid, or a fault that names the key.
  static ShapePtr random_hull(const SceneReader& owner, int vertices, std::uint32_t seed,
                              const Vec3& radii);
  static ShapePtr box(const SceneReader& owner, const Vec3& half_extents);

 private:
  ShapePtr make(SceneReader description) const;
  ShapePtr from_mesh_file(SceneReader& description) const;
  ShapePtr from_mesh_json(const std::filesystem::path& file, const Vec3& scale,
                          const std::string& path) const;

  std::filesystem::path folder_;
  SceneCost& cost_;
  std::map<std::string, ShapePtr> named_;
};

}  // namespace cs550
