#pragma once
/// @file course_file.hpp
/// Reading the course file (TOML).

#include <stdexcept>
#include <string>

#include "gradebook/course/catalogue.hpp"
#include "gradebook/course/course.hpp"

namespace cs550::gradebook {

/// A fault of the course file: file, line, key, what was expected and found, and an example.
class CourseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// @param file its name in messages
/// @param catalogue the labs and tests that the file may name
/// Throws CourseError.
Course parse_course(const std::string& text, const std::string& file, const Catalogue& catalogue);

}  // namespace cs550::gradebook
