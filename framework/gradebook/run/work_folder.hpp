#pragma once
/// @file work_folder.hpp
/// A folder for the files of one task.

#include <filesystem>

namespace cs550::gradebook {

/// A new folder with a name of its own, removed with all that is in it at the end.
class WorkFolder {
 public:
  /// @param parent is made if it is absent @throws std::runtime_error if no folder can be made in it
  explicit WorkFolder(const std::filesystem::path& parent);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace cs550::gradebook
