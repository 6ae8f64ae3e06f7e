#pragma once
/// @file content.hpp
/// The content of a page, as a value that can be sent from another process.

#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/plot.hpp"
#include "pages/base/focus.hpp"
#include "pages/base/solid.hpp"

namespace cs550::pages {

/// A line of a table: a name, and a value with its unit.
struct Fact {
  std::string name;   ///< "kinetic energy"
  std::string value;  ///< "12.3 kJ"
};

/// The content of a page.
struct Content {
  std::vector<Solid> solids;         ///< shaded bodies
  drawing::Drawing drawing;          ///< lines, dots, polygons, labels, legend, notes
  std::vector<drawing::Plot> plots;  ///< beside the picture
  std::vector<Fact> facts;           ///< numbers on the panel
  int step_count = 0;                ///< number of steps in the page's walk
  Focus focus;                       ///< the initial view
  std::string problem;               ///< why there is no picture: an unwritten or failed stage
  std::string lost;                  ///< why the world stands still; empty while it moves
};

}  // namespace cs550::pages
