#pragma once
/// @file roster.hpp
/// The students of a course, and which record is whose.

#include <optional>
#include <string>
#include <vector>

#include "gradebook/course/course.hpp"
#include "gradebook/records/record.hpp"

namespace cs550::gradebook {

struct Student {
  std::string id, name, email, section;
  std::optional<Time> submitted;
  bool on_roster = true;
  std::vector<const Record*> records;
};

/// Whether an entry of the course file is about a student: by id or email, in capitals or not.
bool is_about(const std::string& entry, const Student& student);

/// @param text CSV with a header line: `id`, and optionally name, email, section, submitted
/// @param file its name in messages
/// Throws std::runtime_error for a roster without students or ids, with an id twice, or with a quote
/// that is not closed.
std::vector<Student> parse_roster(const std::string& text, const std::string& file);

/// Gives every record to its student. If a platform has named the student, the record belongs to the
/// one with that email, name or id, or to nobody. Otherwise it belongs to the student whose id, email
/// or name is that of its file or folder. If there is none, it belongs to the only student whose id
/// is in that name, with no letter or digit beside it, or all words of whose name are. If a folder is
/// nobody's, the same holds for the folders in it, and then for the name of the file. Only if no student
/// matches does the name count that the submission itself claims. Records of nobody get a student of their
/// own.
/// @param roster may be empty: then every name is a student
std::vector<Student> assign(std::vector<Student> roster, const std::vector<Record>& records);

/// The ids of the students whom the name of a record fits equally well; empty if it fits fewer than two.
std::vector<std::string> rivals(const std::vector<Student>& roster, const Record& record);

}  // namespace cs550::gradebook
