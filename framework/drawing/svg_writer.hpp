#pragma once
/// @file svg_writer.hpp
/// Writes the elements of SVG that pictures need.

#include <sstream>
#include <string>
#include <vector>

#include "drawing/fitted_view.hpp"
#include "drawing/palette.hpp"

namespace cs550::drawing {

/// A position on the page (pixels).
struct PagePoint {
  double x = 0;  ///< to the right
  double y = 0;  ///< downward
};

/// The part of a text that is at its position.
enum class Anchor : std::uint8_t { Start, Middle, End };

/// The style of a text.
struct TextStyle {
  double size = 13;                             ///< pixels
  Colour colour = drawing::colour(Role::Text);  ///< of the letters
  Anchor anchor = Anchor::Start;                ///< the part at the position
  bool bold = false;                            ///< bold weight
  bool halo = false;                            ///< with a white outline, for text over lines
  bool upward = false;                          ///< rotated by 90° to read upward
};

/// The estimated width of a text (pixels). The fonts of the reader are not known.
double text_width(const std::string& text, double size);

/// Breaks a text into lines of limited width (pixels).
std::vector<std::string> wrap(const std::string& text, double size, double width);

/// Collects the elements of a file.
class SvgWriter {
 public:
  void line(PagePoint from, PagePoint to, Colour colour, double width, bool dashed = false,
            double dash_offset = 0);
  void polyline(const std::vector<PagePoint>& points, Colour colour, double width, bool dashed);
  void polygon(const std::vector<PagePoint>& points, Colour fill, double opacity);
  void outlined_polygon(const std::vector<PagePoint>& points, Colour fill, Colour outline,
                        double outline_width);
  void circle(PagePoint center, double radius, Colour fill, Colour outline, double outline_width);
  /// Shaded like a ball that is lit from the upper left.
  void ball(PagePoint center, double radius, Colour colour, double opacity);
  void rectangle(const Rectangle& area, Colour fill, Colour outline);
  /// The outline of an area.
  void frame(const Rectangle& area, Colour outline);
  void text(PagePoint at, const std::string& text, const TextStyle& style);
  /// Clips the following elements to an area, until end_group().
  void begin_clipped(const Rectangle& area);
  /// Groups the following elements, with a description.
  void begin_group(const std::string& alt_text);
  void end_group();

  /// The complete file. @param title, alt_text for readers who cannot see the picture
  std::string document(double width, double height, const std::string& title,
                       const std::string& alt_text) const;

 private:
  std::ostringstream body_;
  std::ostringstream definitions_;
  int definition_count_ = 0;
};

}  // namespace cs550::drawing
