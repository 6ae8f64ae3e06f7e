#pragma once
/// @file draft_folder.hpp
/// Folders that appear when they are complete.

#include <filesystem>
#include <vector>

namespace cs550::cli {

/// A folder beside the wanted one, on the same disk. It is removed at the end unless it was renamed
/// to the wanted one.
class DraftFolder {
 public:
  explicit DraftFolder(const std::filesystem::path& wanted);
  ~DraftFolder();
  DraftFolder(const DraftFolder&) = delete;
  DraftFolder& operator=(const DraftFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;  ///< a file descriptor; it shows other processes that the draft is in use
};

/// Removes the drafts of the wanted folder that killed processes have left. @returns their paths
std::vector<std::filesystem::path> remove_abandoned_drafts(const std::filesystem::path& wanted);

}  // namespace cs550::cli
