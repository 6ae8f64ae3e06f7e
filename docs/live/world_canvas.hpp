#pragma once
/// @file world_canvas.hpp
/// A running world as flat shapes for a 2D canvas, and a pointer over it that picks, pulls and
/// throws. The browser only fills what it is given.

#include <optional>
#include <string>
#include <vector>

#include "pages/world/world_page.hpp"

namespace cs550::live {

/// Paints a world page. The camera frames the scene when that begins.
class WorldCanvas {
 public:
  /// @param page, camera outlive the canvas
  WorldCanvas(pages::WorldPage& page, pages::Camera& camera);

  /// Frames the scene again before the next picture.
  void frame_again() { is_framed_ = false; }

  /// Whether the camera moves with the selected body, or with the middle of all movable ones.
  void describe(pages::ControlVisitor& visit);

  /// Shapes from back to front, one after the other: kind (0 polygon, 1 line, 2 dashed line, 3 arrow,
  /// 4 dashed arrow, 5 dot, 6 separate segments), colour (0xRRGGBB), opacity, size (width of the line,
  /// radius of the dot; pixels), number of points, then x and y of each (pixels from the top left).
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
  void follow();
  void add_solids();
  void add_solid(const pages::Solid& solid, bool is_outlined);
  /// Fills pixels_. @return whether all vertices are in front of the camera
  bool project_vertices(const pages::Solid& solid);
  bool is_on_canvas() const;
  void add_face(const pages::Solid& solid, Index face);
  /// A face of a body that reaches behind the camera.
  void add_near_face(const pages::Solid& solid, Index face);
  /// Edges of faces that are seen, each once.
  void add_outline(const HalfEdgeMesh& mesh, float opacity);
  void add_polygon(const pages::Rgba& colour, const std::vector<Vec3>& corners);
  void add_overlays();
  void add_line(const drawing::Line& line);
  /// A shape: begin() returns what end() takes after its points.
  /// @{
  std::size_t begin(float kind, const pages::Rgba& colour, float size);
  void add(const Vec2& pixel);
  void end(std::size_t start);
  /// @}

  pages::WorldPage& page_;
  pages::Camera& camera_;
  pages::Projection seen_;  ///< of the last picture
  bool is_framed_ = false;
  bool follows_ = false;
  Vec3 subject_ = Vec3::Zero();    ///< what the camera follows, as last seen (m)
  std::optional<Index> followed_;  ///< the selected body, if the camera follows that
  Real followed_count_ = 0;        ///< bodies whose middle the camera follows
  Real depth_ = 1;                 ///< of the pulled point along the view (m)
  pages::Size canvas_ = {1, 1};

  // The solid that is being painted.
  std::vector<Vec2> pixels_;  ///< its vertices
  std::vector<bool> faces_;   ///< whether the eye is in front of each
  Vec2 least_ = Vec2::Zero();
  Vec2 most_ = Vec2::Zero();

  std::vector<float> shapes_;
};

}  // namespace cs550::live
