#pragma once
/// @file files.hpp
/// Reading files and folders; drafts of folders.

#include <filesystem>
#include <string>
#include <vector>

namespace cs550::cli {

/// The whole of a file. Throws std::runtime_error when it cannot be read.
std::string read_text(const std::filesystem::path& file);

/// All files in a folder and its subfolders, sorted; none when it is absent.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder);

/// SHA-256 of a file, 64 hexadecimal digits.
std::string sha256(const std::filesystem::path& file);

/// Changes when the name or the content of one of the files changes (FNV-1a, 16 hexadecimal
/// digits).
std::string fingerprint_of(const std::vector<std::filesystem::path>& files);

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
};

}  // namespace cs550::cli
