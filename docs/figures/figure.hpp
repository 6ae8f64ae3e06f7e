#pragma once
/// @file figure.hpp
/// What the book shows: pictures that the engine's own code draws, and tables of what it measures.

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "drawing/svg.hpp"

namespace cs550::book {

/// A picture by its name in figures.txt.
struct Figure {
  std::string name;
  std::function<drawing::Page()> draw;
};

/// Columns of numbers for a plot of the same name; empty lines separate blocks.
struct Table {
  std::string name;
  std::function<void(std::ostream&)> measure;
};

// One list for each chapter that has any.
std::vector<Figure> conventions_figures();
std::vector<Figure> rigid_body_figures();
std::vector<Figure> mesh_figures();
std::vector<Figure> climbing_figures();
std::vector<Figure> gauss_map_figures();
std::vector<Figure> axis_figures();
std::vector<Figure> contact_figures();
std::vector<Figure> solver_figures();
std::vector<Figure> mass_figures();

std::vector<Table> rigid_body_tables();
std::vector<Table> collision_tables();
std::vector<Table> solver_tables();
std::vector<Table> scene_tables();
std::vector<Table> rebuild_tables();

}  // namespace cs550::book
