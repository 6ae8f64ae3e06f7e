#pragma once
/// @file world_canvas.hpp
/// A running world as flat shapes for a 2D canvas, and a pointer over it that picks, pulls and
/// throws. The browser only fills what it is given.

#include <string>
#include <vector>

#include "pages/world/world_page.hpp"

namespace cs550::live {

/// Paints a world page. The camera follows nothing: it frames the scene when that begins.
class WorldCanvas {
 public:
  /// @param page, camera outlive the canvas
  WorldCanvas(pages::WorldPage& page, pages::Camera& camera);

  /// Frames the scene again before the next picture.
  void frame_again() { is_framed_ = false; }

  /// Shapes from back to front, one after the other: kind (0 polygon, 1 line, 2 dashed line, 3 arrow,
  /// 4 dashed arrow, 5 dot), colour (0xRRGGBB), opacity, size (width of the line or outline, radius of
  /// the dot; pixels), number of points, then x and y of each (pixels from the top left).
  const std::vector<float>& paint(pages::Size canvas);
  /// What belongs to the last picture as JSON: labels {x, y, text}, legend {text, colour}, notes.
  std::string words() const;

  /// Selects the body under a pixel and pulls it until release(). @return whether there is one
  bool press(const Vec2& pixel);
  /// The pulled body follows the pointer at a constant depth.
  void pull(const Vec2& pixel);
  void release() { page_.let_go(); }
  /// Selects the movable body after the selected one; after the last one none.
  void select_next();
  /// Throws a box from the camera through a pixel.
  void throw_box(const Vec2& pixel);

 private:
  void add_solids();
  void add_face(const pages::Solid& solid, Index face, float outline);
  void add_polygon(const pages::Rgba& colour, float outline, const std::vector<Vec3>& corners);
  void add_overlays();
  void add_line(const drawing::Line& line);
  void begin(float kind, const pages::Rgba& colour, float size, std::size_t points);
  void add(const Vec3& point);

  pages::WorldPage& page_;
  pages::Camera& camera_;
  pages::Projection seen_;  ///< of the last picture
  bool is_framed_ = false;
  Real depth_ = 1;  ///< of the pulled point along the view (m)
  std::vector<float> shapes_;
};

}  // namespace cs550::live
