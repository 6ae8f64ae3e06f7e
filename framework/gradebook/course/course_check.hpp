#pragma once
/// @file course_check.hpp
/// Whether a parsed course file has only known keys with values of the right type.

#include <toml++/toml.h>

#include <string>

#include "gradebook/course/catalogue.hpp"

namespace cs550::gradebook {

/// Throws CourseError for the first fault.
/// @param file its name in messages
void check_course(const toml::table& top, const std::string& file, const Catalogue& catalogue);

}  // namespace cs550::gradebook
