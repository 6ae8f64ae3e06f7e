#pragma once
/// @file solid_renderer.hpp
/// Bodies with flat faces, crisp edges and soft shadows.

#include <map>
#include <span>

#include "viewer/camera.hpp"
#include "viewer/render/backdrop.hpp"
#include "viewer/render/focus.hpp"
#include "viewer/render/shadow_map.hpp"
#include "viewer/render/solid.hpp"
#include "viewer/render/solid_mesh.hpp"

namespace cs550::viewer {

/// Draws solids; keeps their meshes on the graphics card as long as they are drawn.
class SolidRenderer {
 public:
  SolidRenderer();

  /// Prepares a frame: what is drawn, and the shadows that it throws.
  void begin(std::span<const Solid> solids, const Focus& focus);
  /// Opaque solids.
  void draw_opaque(const Projection& projection, Size canvas) const;
  /// Translucent solids, from back to front; after everything that is opaque.
  void draw_translucent(const Projection& projection, Size canvas) const;

 private:
  struct Cached {
    MeshPtr mesh;  ///< keeps the address from being used again
    SolidMesh on_card;
    bool is_used;
  };
  /// Neighbours in the buffer of instances that share a mesh.
  struct Batch {
    const SolidMesh* mesh;
    int first;
    int count;
    Vec3 position;  ///< of the first one
    bool is_ground;
  };

  const SolidMesh& on_card(const MeshPtr& mesh);
  void fill(std::span<const Solid> solids);
  void throw_shadows();
  void use(const Projection& projection, Size canvas) const;

  Shader shader_;
  Shader shadow_shader_;
  ShadowMap shadow_map_;
  Buffer instances_;
  std::map<const HalfEdgeMesh*, Cached> meshes_;
  std::vector<Batch> opaque_;
  std::vector<Batch> translucent_;
  Matrix4 light_matrix_ = Matrix4::Identity();
  Focus focus_;
};

}  // namespace cs550::viewer
