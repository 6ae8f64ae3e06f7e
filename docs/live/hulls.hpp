#pragma once
/// @file hulls.hpp
/// Hulls for the browser, which has no hull library. The browser's engine lists the point clouds of the
/// shipped scenes, the native one answers with their hulls (book_figures --hulls), and the browser
/// looks them up.

#include <string>

namespace cs550::live {

/// The point clouds of all shipped scenes as JSON: {key: [x, y, z, …]}.
std::string shipped_clouds();
/// Takes hulls as JSON: {key: [three indices of points per triangle, …]}.
void learn_hulls(const std::string& text);

}  // namespace cs550::live
