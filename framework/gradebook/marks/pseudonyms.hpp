#pragma once
/// @file pseudonyms.hpp
/// Records and marks without names.

#include <map>
#include <string>
#include <vector>

#include "gradebook/course/course.hpp"
#include "gradebook/marks/roster.hpp"

namespace cs550::gradebook {

/// A class in which nobody can be recognised without the key.
struct PseudonymousClass {
  std::vector<Record> records;
  std::vector<Student> roster;
  Course course;                           ///< its entries name pseudonyms
  std::map<std::string, std::string> key;  ///< id by pseudonym
};

/// A pseudonym derives from the student's id and the secret of the course, so it is the same in
/// every report and tells nothing by its place. Names, addresses, paths, the names of ignored files,
/// compiler messages, what a test printed, reasons of adjustments and what went wrong in the grader
/// are left out. Of times remains what marks need.
PseudonymousClass with_pseudonyms(const std::vector<Record>& records,
                                  const std::vector<Student>& roster, const Course& course);

}  // namespace cs550::gradebook
