#pragma once
/// @file draft_folder.hpp
/// A folder for what is not finished.

#include <unistd.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace cs550::cli {

/// A folder beside the wished-for one, on the same disk. At the end it is gone, unless it was moved
/// to its place: nothing half-written stays behind.
class DraftFolder {
 public:
  explicit DraftFolder(const std::filesystem::path& wanted)
      : path_(wanted.string() + ".partial-" + std::to_string(getpid())) {
    std::filesystem::create_directories(path_);
  }
  ~DraftFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  DraftFolder(const DraftFolder&) = delete;
  DraftFolder& operator=(const DraftFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace cs550::cli
