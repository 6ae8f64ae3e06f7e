#pragma once
/// @file content.hpp
/// All that a page shows, as a value that another process can send.

#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/plot.hpp"
#include "pages/base/focus.hpp"
#include "pages/base/solid.hpp"

namespace cs550::pages {

/// A name and a value with its unit, a line of a table.
struct Fact {
  std::string name;   ///< "kinetic energy"
  std::string value;  ///< "12.3 kJ"
};

/// What a page shows.
struct Content {
  std::vector<Solid> solids;         ///< shaded bodies
  drawing::Drawing drawing;          ///< lines, dots, polygons, labels, legend, notes
  std::vector<drawing::Plot> plots;  ///< beside the picture
  std::vector<Fact> facts;           ///< numbers on the panel
  int step_count = 0;                ///< how many steps the page's walk has
  Focus focus;                       ///< what the camera sees at first
  std::string problem;               ///< why there is no picture: an unwritten or broken stage
};

}  // namespace cs550::pages
