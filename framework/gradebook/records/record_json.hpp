#pragma once
/// @file record_json.hpp
/// Records as JSON.

#include <string>

#include "gradebook/records/record.hpp"

namespace cs550::gradebook {

std::string to_json(const Record& record);
std::string to_json(const LabRecord& lab);

/// Throw std::runtime_error, which names `file`, if the text is not what to_json() writes.
Record record_from_json(const std::string& text, const std::string& file);
LabRecord lab_from_json(const std::string& text, const std::string& file);

/// The result that the judge program writes for one lab.
/// Throws std::runtime_error, which names `file`.
LabRecord lab_from_judge(const std::string& text, const std::string& file);
/// The same of a student's own tests.
OwnTests own_tests_from_judge(const std::string& text, const std::string& file);

}  // namespace cs550::gradebook
