#pragma once
/// @file svg.hpp
/// Drawings and plots as SVG files, for failing tests and for the book.

#include <string>
#include <variant>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/plot.hpp"
#include "drawing/view.hpp"

namespace cs550::drawing {

/// A drawing with a view.
struct Scene {
  Drawing drawing;  ///< the contents
  View view;        ///< the viewpoint
};

/// One picture of a page.
using Panel = std::variant<Scene, Plot>;

/// Pictures side by side, such as expected beside got.
struct Page {
  std::string title;               ///< above all panels
  std::string alt_text;            ///< a description for readers who cannot see it
  std::vector<Panel> panels;       ///< from left to right
  std::vector<std::string> notes;  ///< sentences below the panels
  bool framed_by_first = false;    ///< all scenes show the same part of space as the first
  Size panel_size = {420, 360};    ///< of each panel (pixels)
};

/// Writes an SVG file. Elements and values that are not finite are left out, with a note.
std::string write_svg(const Page& page);
/// One drawing.
std::string write_svg(const Drawing& drawing, const View& view = {}, const Size& size = {});
/// One plot.
std::string write_svg(const Plot& plot, const Size& size = {});

}  // namespace cs550::drawing
