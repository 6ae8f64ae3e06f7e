#pragma once
/// @file settings.hpp
/// The course file and the roster of a run. The output folder keeps a copy of both, so reports can
/// be made again without naming them.

#include <filesystem>
#include <string>
#include <vector>

#include "gradebook/course/catalogue.hpp"
#include "gradebook/course/course.hpp"
#include "gradebook/intake/discovery.hpp"
#include "gradebook/marks/roster.hpp"
#include "gradebook/records/record_folder.hpp"

namespace cs550::gradebook {

struct Settings {
  Catalogue catalogue;
  Course course;
  std::vector<Student> roster;
  std::string course_text, roster_text;  ///< of the files; empty without one
};

/// @param course,roster may be empty: then the copies in `folder` are read, if there are any
/// Throws CourseError, or std::runtime_error for a roster that cannot be used.
Settings read_settings(const std::filesystem::path& root, const std::filesystem::path& course,
                       const std::filesystem::path& roster, const std::filesystem::path& folder);

/// Copies both files into the folder. Only the owner can read them: the course file has the secret.
void keep_settings(const Settings& settings, const std::filesystem::path& folder);

/// Prints what beside submissions is not read.
void print_skipped(const Discovery& found);

/// Prints the entries of the course file that are about no student. A single submission without a roster
/// is a part of a class, and says nothing about them.
void print_entries_about_nobody(const Settings& settings, const std::vector<Record>& records);

/// Prints which submissions belong to nobody on the roster, who has handed in none of the graded
/// labs, and whose labs are in several submissions, so that milestones are missing.
void print_students_to_look_at(const Settings& settings, const std::vector<Record>& records);

/// Prints which records are older than the course keeps them.
void print_expired(const RecordFolder& folder, const Course& course);

}  // namespace cs550::gradebook
