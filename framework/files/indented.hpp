#pragma once
/// @file indented.hpp
/// Lines of at most 80 columns.

#include <cstddef>
#include <string>
#include <string_view>

namespace cs550::files {

/// Every line of the text with `spaces` spaces before it, ending in a newline; empty for no text.
/// A line longer than 80 columns is broken between two words.
std::string indented(std::string_view text, std::size_t spaces);

}  // namespace cs550::files
