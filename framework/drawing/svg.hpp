#pragma once
/// @file svg.hpp
/// Drawings and plots as SVG: one file that any browser shows, for failing tests and for the book.

#include <string>
#include <variant>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/plot.hpp"
#include "drawing/view.hpp"

namespace cs550::drawing {

/// A drawing and from where it is seen.
struct Scene {
  Drawing drawing;  ///< what
  View view;        ///< from where
};

/// One picture of a page.
using Panel = std::variant<Scene, Plot>;

/// Pictures side by side, such as expected beside got.
struct Page {
  std::string title;               ///< above them all
  std::string alt_text;            ///< what is to be seen, for those who cannot see it
  std::vector<Panel> panels;       ///< from left to right
  std::vector<std::string> notes;  ///< sentences below them
  bool framed_by_first = false;    ///< every scene shows the part of space that the first one fills
  Size panel_size = {420, 360};    ///< of each panel (pixels)
};

/// Writes an image. Elements that are not finite are left out, with a note that says so.
std::string write_svg(const Page& page);
/// One drawing.
std::string write_svg(const Drawing& drawing, const View& view = {}, const Size& size = {});
/// One plot.
std::string write_svg(const Plot& plot, const Size& size = {});

}  // namespace cs550::drawing
