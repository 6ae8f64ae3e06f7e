#pragma once
/// @file solid_mesh.hpp
/// A half-edge mesh on the GPU.

#include "cs550/half_edge_mesh.hpp"
#include "viewer/gl/handle.hpp"

namespace cs550::viewer {

/// The triangles of a mesh's faces, for instanced drawing.
class SolidMesh {
 public:
  explicit SolidMesh(const HalfEdgeMesh& mesh);

  /// The record of an instance: position (3), quaternion x y z w (4), colour (4), ground (1).
  static constexpr int instance_floats = 12;

  /// Draws one copy per instance. @param instances buffer, @param first index of the first instance
  void draw(const Buffer& instances, int first, int count) const;
  /// The same with half as many triangles, without marking the edges of faces.
  void draw_outline(const Buffer& instances, int first, int count) const;

 private:
  void bind(const Buffer& instances, int first) const;

  VertexArray layout_;
  Buffer vertices_;
  Buffer indices_;
  GLsizei index_count_ = 0;    ///< of the triangles from each face's middle
  GLsizei outline_count_ = 0;  ///< of the following triangles, from each face's first corner
};

}  // namespace cs550::viewer
