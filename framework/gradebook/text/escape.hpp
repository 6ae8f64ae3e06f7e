#pragma once
/// @file escape.hpp
/// Text that a student may have written, made harmless for the format that it is put into.

#include <cstddef>
#include <string>
#include <string_view>

namespace cs550::gradebook {

/// Printable UTF-8: terminal escape sequences and control characters other than newline and tab are
/// removed, invalid bytes become U+FFFD.
std::string plain_text(std::string_view text);

/// plain_text() on a single line.
std::string plain_line(std::string_view text);

/// plain_text() cut to `most` bytes at the end of a character, with a note that it was cut.
std::string shortened(std::string_view text, std::size_t most);

/// For the text and the attributes of HTML and XML.
std::string html(std::string_view text);

/// A field of a CSV line. A field that a spreadsheet would take for a formula begins with a quote.
std::string csv(std::string_view field);

/// A word of a command as a shell reads it.
std::string in_shell(const std::string& word);

/// A word within a line of Markdown, without any markup of its own.
std::string markdown(std::string_view text);

/// A block of Markdown that shows the text as it is.
std::string markdown_block(std::string_view text);

}  // namespace cs550::gradebook
