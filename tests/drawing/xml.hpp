#pragma once
/// @file xml.hpp
/// A minimal XML parser that checks whether a text is well-formed.

#include <string>

namespace cs550::test {

/// The first error in a document, or an empty string if it is well-formed: one root, tags closed in
/// order, quoted attributes without duplicates, no bare `&` or `<`, no control characters.
std::string xml_fault(const std::string& document);

/// The number of occurrences of a text.
int count(const std::string& document, const std::string& text);

}  // namespace cs550::test
