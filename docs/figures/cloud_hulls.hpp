#pragma once
/// @file cloud_hulls.hpp
/// Hulls for the browser (docs/live/hulls.hpp).

#include <string>

namespace cs550::book {

/// Writes the hull of each point cloud that the browser's engine has listed.
/// @throws std::runtime_error with the reason
void answer_clouds(const std::string& clouds, const std::string& output);

}  // namespace cs550::book
