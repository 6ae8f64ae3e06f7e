#pragma once
/// @file picture.hpp
/// Pictures of failures: what was expected beside what came out.

#include <functional>
#include <string>

#include "drawing/svg.hpp"

namespace cs550::test {

/// Writes the picture of the running test, build/results/pictures/Lab3.Name.svg or another folder
/// that the environment variable CS550_PICTURES names. Never throws: a picture that cannot be drawn
/// or written is left out.
/// @param draw returns SVG, which replaces the test's picture
/// @return the file, relative to the working directory if it is below it; empty if there is none
std::string write_picture(const std::function<std::string()>& draw);

/// Two drawings side by side. Their titles should say what they show, not which is which. Both show
/// the part of space that the expected one fills: what came out may be anywhere.
/// @param title what both show
/// @param note a sentence below them, may be empty
std::string expected_beside_got(const std::string& title, drawing::Drawing expected,
                                drawing::Drawing got, const drawing::View& view = {},
                                const std::string& note = "");

/// Several pictures side by side.
std::string side_by_side(const std::string& title, std::vector<drawing::Panel> panels,
                         const std::string& note = "");

}  // namespace cs550::test
