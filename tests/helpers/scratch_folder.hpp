#pragma once
/// @file scratch_folder.hpp
/// A temporary folder of a test.

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace cs550::test {

/// A folder that is empty at the start and removed at the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "cs550_test.XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~ScratchFolder() {
    std::error_code
        ignored;  // another process may have left something in it that cannot be removed
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace cs550::test
