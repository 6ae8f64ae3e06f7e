#pragma once
/// @file discovery.hpp
/// Finding the submissions in what the instructor names, and reading them.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gradebook/course/catalogue.hpp"
#include "gradebook/intake/submission.hpp"

namespace cs550::gradebook {

/// A submission that was found but not yet read.
struct FoundSubmission {
  std::filesystem::path source;  ///< archive or folder
  std::string name;              ///< unique, safe as a file name
  std::string student;           ///< from the names of the file and its folder
  /// Seconds since 1970: modification time of an archive. That of a folder changes when it is copied or
  /// unpacked, so it is unknown when the folder was handed in.
  std::optional<long> time;
  std::string trouble;         ///< why it must not be read; empty if it may
  bool is_identified = false;  ///< whether a platform named the student instead
  /// The names of the folders around it, from the outermost on, that may be a student's.
  std::vector<std::string> folders = {};
};

struct Discovery {
  std::vector<FoundSubmission> submissions;
  std::vector<IgnoredFile> skipped;  ///< files beside them that are not submissions
};

/// Every archive and folder among `sources`. A folder without lab files of its own contains
/// submissions: archives, folders, or one folder per student. The student of one with the name of a
/// lab, such as lab3.zip, is the folder around it, whether that was named or found. Of several folders it is the
/// outermost, which may be that of a section: assign() looks at all of them.
/// Throws std::runtime_error if a source does not exist or is no submission.
Discovery find_submissions(const std::vector<std::filesystem::path>& sources,
                           const Catalogue& catalogue);

/// The absolute path of a submission, as its record has it.
std::string recorded_path(const FoundSubmission& found);

/// Never throws: what is wrong with it becomes its `trouble`, unless it has one.
Submission read_submission(const FoundSubmission& found, const Catalogue& catalogue);

/// The name of a file without the ending of an archive.
std::string without_ending(const std::string& name);

/// The name of a record or a student's file: other characters than letters, digits and ._- become
/// an underscore.
std::string safe_name(const std::string& name);

}  // namespace cs550::gradebook
