#pragma once
/// @file junit.hpp
/// Results as JUnit XML.

#include <string>

#include "gradebook/records/record.hpp"

namespace cs550::gradebook {

/// A suite per lab. Points are properties of each test, and the first line of its system-out, for
/// readers that ignore properties. A blocked test is a failure.
std::string junit_xml(const Record& record);

}  // namespace cs550::gradebook
