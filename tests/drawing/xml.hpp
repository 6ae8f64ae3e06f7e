#pragma once
/// @file xml.hpp
/// Just enough of an XML reader to know whether a text is well-formed.

#include <string>

namespace cs550::test {

/// What is wrong with a document, in words; empty if it is well-formed: one root, tags closed in
/// order, attributes quoted and named once, no bare `&` or `<`, no control characters.
std::string xml_fault(const std::string& document);

/// How often a text occurs.
int count(const std::string& document, const std::string& text);

}  // namespace cs550::test
