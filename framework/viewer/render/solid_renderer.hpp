#pragma once
/// @file solid_renderer.hpp
/// Bodies with flat faces, crisp edges and soft shadows.

#include <map>
#include <span>

#include "pages/base/camera.hpp"
#include "pages/base/focus.hpp"
#include "pages/base/solid.hpp"
#include "viewer/gl/canvas.hpp"
#include "viewer/render/backdrop.hpp"
#include "viewer/render/shadow_map.hpp"
#include "viewer/render/solid_mesh.hpp"

namespace cs550::viewer {

using namespace pages;

/// Draws solids, and keeps their meshes on the GPU as long as they are drawn.
class SolidRenderer {
 public:
  SolidRenderer();

  /// Sets the solids to draw. @return whether they have changed
  bool set(std::span<const Solid> solids, const Focus& focus);
  /// Prepares a frame: the order of drawing, and the shadows.
  void begin(const Projection& projection, RenderQuality quality);
  /// Draws opaque solids.
  void draw_opaque(const Projection& projection, Size canvas) const;
  /// Draws translucent solids from back to front; call it after everything opaque is drawn.
  void draw_translucent(const Projection& projection, Size canvas) const;

 private:
  struct Cached {
    MeshPtr mesh;  ///< keeps the address from being reused
    SolidMesh on_card;
    bool is_used;
  };
  /// Consecutive instances in the buffer that share a mesh.
  struct Batch {
    const SolidMesh* mesh;
    int first;
    int count;
    Vec3 position;  ///< of the first one
    bool is_ground;
  };

  /// The shaders and shadow map of a quality.
  struct Look {
    Shader shader;
    ShadowMap shadows;
    bool are_shadows_drawn;  ///< since something moved
  };

  const SolidMesh& on_card(const MeshPtr& mesh);
  std::vector<const Solid*> drawing_order(const Projection& projection) const;
  void fill(const Projection& projection);
  void throw_shadows(Look& look);
  void use(const Projection& projection, Size canvas) const;

  Shader shadow_shader_;
  Look fine_;
  Look quick_;
  const Look* look_ = nullptr;  ///< of the present frame
  Buffer instances_;
  std::map<const HalfEdgeMesh*, Cached> meshes_;
  std::vector<Batch> opaque_;
  std::vector<Batch> translucent_;
  Matrix4 light_matrix_ = Matrix4::Identity();
  std::vector<Solid> solids_;
  Focus focus_;
};

}  // namespace cs550::viewer
