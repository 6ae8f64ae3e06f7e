#pragma once
/// @file svg_writer.hpp
/// The few elements of SVG that pictures are made of.

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

/// Where a text is fixed to its position.
enum class Anchor : std::uint8_t { Start, Middle, End };

/// How a text looks.
struct TextStyle {
  double size = 13;                             ///< pixels
  Colour colour = drawing::colour(Role::Text);  ///< of the letters
  Anchor anchor = Anchor::Start;                ///< which end is fixed
  bool bold = false;                            ///< heavier
  bool halo = false;                            ///< white around the letters, over lines
  bool upward = false;                          ///< turned by a quarter to read from below
};

/// With `&`, `<`, `>` and quotes replaced, and without characters that XML forbids.
std::string escape_xml(const std::string& text);

/// How wide a text comes out (pixels): a guess, since nobody knows the reader's fonts.
double text_width(const std::string& text, double size);

/// Breaks a text into lines of at most a width (pixels).
std::vector<std::string> wrap(const std::string& text, double size, double width);

/// Gathers elements.
class SvgWriter {
 public:
  void line(PagePoint from, PagePoint to, Colour colour, double width, bool dashed = false,
            double dash_offset = 0);
  void polyline(const std::vector<PagePoint>& points, Colour colour, double width, bool dashed);
  void polygon(const std::vector<PagePoint>& points, Colour fill, double opacity);
  void outlined_polygon(const std::vector<PagePoint>& points, Colour fill, Colour outline,
                        double outline_width);
  void circle(PagePoint center, double radius, Colour fill, Colour outline, double outline_width);
  /// Shaded like a ball lit from the upper left.
  void ball(PagePoint center, double radius, Colour colour, double opacity);
  void rectangle(const Rectangle& area, Colour fill, Colour outline);
  /// The outline of an area.
  void frame(const Rectangle& area, Colour outline);
  void text(PagePoint at, const std::string& text, const TextStyle& style);
  /// What follows is cut off outside of an area, until end_group().
  void begin_clipped(const Rectangle& area);
  /// What follows belongs together and is described by a sentence.
  void begin_group(const std::string& alt_text);
  void end_group();

  /// A whole file. @param title, alt_text for those who cannot see the picture
  std::string document(double width, double height, const std::string& title,
                       const std::string& alt_text) const;

 private:
  std::ostringstream body_;
  std::ostringstream definitions_;
  int definition_count_ = 0;
};

}  // namespace cs550::drawing
