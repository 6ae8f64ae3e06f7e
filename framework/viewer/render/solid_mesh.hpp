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

 private:
  VertexArray layout_;
  Buffer vertices_;
  GLsizei vertex_count_;
};

}  // namespace cs550::viewer
