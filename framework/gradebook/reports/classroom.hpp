#pragma once
/// @file classroom.hpp
/// Results for GitHub Classroom.
/// https://github.com/classroom-resources/autograding-grading-reporter

#include <string>

#include "gradebook/records/record.hpp"

namespace cs550::gradebook {

/// The visible tests only: students can read what a workflow prints.
std::string classroom_json(const Record& record);

}  // namespace cs550::gradebook
