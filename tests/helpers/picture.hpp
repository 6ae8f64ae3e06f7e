#pragma once
/// @file picture.hpp
/// Pictures of failures: expected beside got.

#include <functional>
#include <string>

#include "drawing/svg.hpp"

namespace cs550::test {

/// Writes the picture of the running test, build/results/pictures/Lab3.Name.svg. The environment
/// variable CS550_PICTURES can name another folder. Never throws: a picture that cannot be drawn or
/// written is left out.
/// @param draw returns SVG that replaces the test's earlier picture
/// @return the file, relative to the working directory if inside it, or empty if there is none
std::string write_picture(const std::function<std::string()>& draw);

/// Two drawings side by side. Their titles should describe what they show, not which is which. Both
/// show the part of space of the expected one, because the other may be anywhere.
/// @param title of both
/// @param note a sentence below them, or empty
std::string expected_beside_got(const std::string& title, drawing::Drawing expected,
                                drawing::Drawing got, const drawing::View& view = {},
                                const std::string& note = "");

/// Several pictures side by side.
std::string side_by_side(const std::string& title, std::vector<drawing::Panel> panels,
                         const std::string& note = "");

}  // namespace cs550::test
