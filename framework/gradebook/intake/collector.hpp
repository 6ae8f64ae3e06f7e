#pragma once
/// @file collector.hpp
/// Builds a submission from its files, one by one, within limits.

#include <string>

#include "gradebook/course/catalogue.hpp"
#include "gradebook/intake/submission.hpp"

namespace cs550::gradebook {

/// A submission beyond one of these is not read.
struct IntakeLimits {
  int entries = 20000;                       ///< files, folders and links
  std::size_t unpacked = 256 * 1024 * 1024;  ///< bytes of all files, also of those not taken
  std::size_t file = 1024 * 1024;            ///< bytes of one file that is taken
  int files_of_lab = 200;
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
  /// Sorts the files, and notes if there are none.
  void finish();

 private:
  void read_manifest(const std::string& text);

  Submission& submission_;
  const Catalogue& catalogue_;
};

}  // namespace cs550::gradebook
