#pragma once
/// @file draft_folder.hpp
/// Folders that appear when they are complete.

#include <filesystem>
#include <vector>

namespace cs550::cli {

/// A draft of a folder, beside the wanted one and therefore on the same disk:
/// `wanted.partial-PROCESS/cs550-draft`. Both levels are removed at the end. A program renames the
/// draft to the wanted folder once it is complete.
class DraftFolder {
 public:
  /// By this name, a folder that a killed process has left is told from one of the user's.
  static constexpr const char* content = "cs550-draft";

  explicit DraftFolder(const std::filesystem::path& wanted);
  ~DraftFolder();
  DraftFolder(const DraftFolder&) = delete;
  DraftFolder& operator=(const DraftFolder&) = delete;

  std::filesystem::path path() const { return outer_ / content; }

 private:
  std::filesystem::path outer_;
  int lock_ = -1;  ///< a file descriptor; it shows other processes that the draft is in use
};

/// Removes the drafts of the wanted folder that killed processes have left. A folder that contains
/// anything else stays, and so does one that cannot be removed, such as another user's.
/// @returns the paths of those that were removed
std::vector<std::filesystem::path> remove_abandoned_drafts(const std::filesystem::path& wanted);

}  // namespace cs550::cli
