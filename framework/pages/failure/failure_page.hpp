#pragma once
/// @file failure_page.hpp
/// The page of a failing test: the drawings of its picture.

#include <filesystem>
#include <memory>

#include "pages/base/page.hpp"

namespace cs550::pages {

/// @param picture an SVG file that a failing test has written, such as Lab4.Name.svg
/// @throws std::invalid_argument if it cannot be read or contains no drawings
std::unique_ptr<Page> make_failure_page(const std::filesystem::path& picture);

}  // namespace cs550::pages
