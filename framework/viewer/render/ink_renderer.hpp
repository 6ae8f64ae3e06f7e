#pragma once
/// @file ink_renderer.hpp
/// Drawings in three dimensions: lines and dots of constant width, polygons, balls.

#include <initializer_list>
#include <vector>

#include "drawing/drawing.hpp"
#include "pages/base/camera.hpp"
#include "viewer/gl/handle.hpp"
#include "viewer/gl/shader.hpp"

namespace cs550::viewer {

using namespace pages;

/// Draws everything in a Drawing except its labels.
class InkRenderer {
 public:
  InkRenderer();

  /// Prepares a frame. @param scale pixels per pixel of the drawing: above 1 on a high-resolution
  /// screen
  /// @param eye position of the camera (m)
  /// @return whether anything has changed since the last frame
  bool begin(const drawing::Drawing& drawing, float scale, const Vec3& eye);
  /// Draws balls and polygons; call it after opaque solids are drawn.
  void draw_areas(const Projection& projection) const;
  /// Draws lines and dots, hidden ones fainter; call it last.
  void draw_strokes(const Projection& projection, Size canvas) const;

 private:
  /// A buffer of records of one size.
  struct Batch {
    VertexArray layout;
    Buffer buffer;
    std::vector<float> records;  ///< the contents of the buffer
    GLsizei count = 0;           ///< of records
  };

  static bool fill(Batch& batch, std::vector<float> records, std::initializer_list<GLint> parts,
                   GLuint divisor);
  void draw_both(const Shader& shader, const Batch& batch, const Projection& projection,
                 Size canvas) const;

  Shader line_shader_;
  Shader dot_shader_;
  Shader polygon_shader_;
  Shader ball_shader_;
  Batch lines_;
  Batch dots_;
  Batch triangles_;
  GLsizei covering_ = 0;  ///< number of vertices of polygons that hide strokes; these come first
  Batch balls_;
};

}  // namespace cs550::viewer
