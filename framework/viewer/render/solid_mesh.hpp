#pragma once
/// @file solid_mesh.hpp
/// A half-edge mesh on the graphics card.

#include "cs550/half_edge_mesh.hpp"
#include "viewer/gl/handle.hpp"

namespace cs550::viewer {

/// Triangles of a mesh's faces, ready to be drawn many times.
class SolidMesh {
 public:
  explicit SolidMesh(const HalfEdgeMesh& mesh);

  /// What an instance is: position (3), quaternion x y z w (4), colour (4), ground (1).
  static constexpr int instance_floats = 12;

  /// Draws one copy per instance. @param instances buffer, @param first place of the first one
  void draw(const Buffer& instances, int first, int count) const;
  /// The same with half the triangles, which do not show where edges are.
  void draw_outline(const Buffer& instances, int first, int count) const;

 private:
  void bind(const Buffer& instances, int first) const;

  VertexArray layout_;
  Buffer vertices_;
  Buffer indices_;
  GLsizei index_count_ = 0;    ///< of the triangles from each face's middle
  GLsizei outline_count_ = 0;  ///< of those that follow them, from each face's first corner
};

}  // namespace cs550::viewer
