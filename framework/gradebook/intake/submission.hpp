#pragma once
/// @file submission.hpp
/// What a student handed in, reduced to the files that belong to a lab.

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace cs550::gradebook {

struct SourceFile {
  std::string path;  ///< relative to the lab's folder
  std::string text;
};

/// A file, or a whole folder, that was not taken.
struct IgnoredFile {
  std::string path;
  std::string reason;
  int files = 1;
};

struct Submission {
  std::string name;     ///< of its record; letters, digits and ._- only
  std::string source;   ///< the file or folder that was handed in
  std::string path;     ///< of that file or folder
  std::string student;  ///< from the name of that file or folder
  /// The names of the folders around it, from the outermost on, that may be a student's.
  std::vector<std::string> folders;
  bool is_identified = false;  ///< whether a platform named the student instead
  /// What the manifest of ./cs550 submit claims; empty without one.
  std::string claimed_student, claimed_date, starter;
  std::optional<long> file_time;  ///< seconds since 1970: when it was handed in, if that is known
  std::map<int, std::vector<SourceFile>> labs;  ///< by number, files sorted by path
  /// The labs that came as their folder in the student's copy, from which no file is missing.
  std::set<int> whole_labs;
  std::vector<IgnoredFile> ignored;
  std::string trouble;  ///< why it could not be read; empty if it could

  /// SHA-256 of all that was taken.
  std::string hash() const;
  /// SHA-256 of the files of one lab.
  std::string lab_hash(int lab) const;
};

}  // namespace cs550::gradebook
