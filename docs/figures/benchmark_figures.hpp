#pragma once
/// @file benchmark_figures.hpp
/// What `./cs550 bench --json` has measured, as pictures.

#include <string>
#include <vector>

#include "figure.hpp"

namespace cs550::book {

/// Cost against n, and the frontier of error over time. What was not measured is left out.
/// @param json the report
std::vector<Figure> benchmark_figures(const std::string& json);

}  // namespace cs550::book
