#pragma once
/// @file collector.hpp
/// Builds a submission from its files, one by one, within limits. Their order does not matter, unless
/// two have the same path.

#include <map>
#include <string>
#include <vector>

#include "gradebook/course/catalogue.hpp"
#include "gradebook/intake/lab_path.hpp"
#include "gradebook/intake/submission.hpp"

namespace cs550::gradebook {

/// A submission beyond one of these is not read.
struct IntakeLimits {
  int entries = 20000;  ///< files, folders and links
  /// Bytes of all files; in an archive also of those not taken.
  std::size_t unpacked = 256 * 1024 * 1024;
  std::size_t file = 1024 * 1024;    ///< bytes of one file that is taken
  std::size_t manifest = 64 * 1024;  ///< bytes of the manifest of ./cs550 submit
  int files_of_lab = 100;            ///< with its starter; grade_lab refuses a lab with more
};

class Collector {
 public:
  Collector(Submission& submission, const Catalogue& catalogue)
      : submission_(submission), catalogue_(catalogue) {}

  /// Whether the content of this file is needed. Otherwise the reason was noted.
  bool wants(const std::string& path);
  /// Takes a file that is wanted.
  void take(const std::string& path, std::string text);
  /// Notes that a file or folder is not taken.
  void ignore(const std::string& path, const std::string& reason);
  /// Chooses and sorts the files of each lab, and notes if there are none.
  void finish();

 private:
  /// A file that may be graded.
  struct Candidate {
    std::string path;  ///< in the submission
    LabPath place;
    std::string text;
  };

  void read_manifest(const std::string& text);
  void choose(std::vector<Candidate> candidates);
  void add(Candidate file);

  Submission& submission_;
  const Catalogue& catalogue_;
  std::map<int, std::vector<Candidate>> candidates_;  ///< by lab
};

}  // namespace cs550::gradebook
