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

/// Draws what a Drawing holds, save its labels, which are text.
class InkRenderer {
 public:
  InkRenderer();

  /// Prepares a frame. @param scale pixels per pixel of the drawing: above 1 on a fine screen
  /// @param eye from where it is seen (m)
  /// @return whether anything differs from the frame before
  bool begin(const drawing::Drawing& drawing, float scale, const Vec3& eye);
  /// Balls and polygons; after opaque solids.
  void draw_areas(const Projection& projection) const;
  /// Lines and dots, those behind something fainter; after everything else.
  void draw_strokes(const Projection& projection, Size canvas) const;

 private:
  /// A buffer of equal records and how many they are.
  struct Batch {
    VertexArray layout;
    Buffer buffer;
    std::vector<float> records;  ///< what is in the buffer
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
  GLsizei covering_ = 0;  ///< vertices of polygons that hide what is behind them; they come first
  Batch balls_;
};

}  // namespace cs550::viewer
