#pragma once
/// @file terminal.hpp
/// How output looks: colours only where someone sees them, blocks of text that keep their indent.

#include <cstddef>
#include <string>
#include <string_view>

namespace cs550::cli {

enum class Colour { Red, Green, Yellow, Bold, Faint };

/// The text in a colour; plain when standard output is no terminal, or NO_COLOR is set.
std::string coloured(std::string_view text, Colour colour);

/// Every line of the text with `spaces` spaces before it, ending in a newline; empty for no text.
/// A line that would pass column 80 goes on in the next, between two words.
std::string indented(std::string_view text, std::size_t spaces);

/// The text filled up to `width` columns with spaces.
std::string padded(const std::string& text, std::size_t width);

}  // namespace cs550::cli
