#include "files/path_argument.hpp"

#include <sys/stat.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "files/output_file.hpp"

namespace cs550::files {

std::string fault_of_path(const std::string& word) {
  if (word.empty()) return "expected the path of a file or folder, found an empty text";
  struct stat ignored {};
  if (lstat(word.c_str(), &ignored) != 0 && errno == ENAMETOOLONG) {
    return "expected a path that the file system allows, found " + std::to_string(word.size()) +
           " letters";
  }
  return "";
}

std::string fault_of_ending(const std::string& word, const std::string& ending) {
  namespace fs = std::filesystem;
  if (fs::path(word).extension() == ending) return "";
  std::error_code unknown;
  const fs::file_status status = fs::status(word, unknown);
  // Standard output may be a file.
  const bool is_file = fs::is_regular_file(status) && !is_link_of_the_system(word);
  const bool is_absent = status.type() == fs::file_type::not_found;
  if (!is_file && !is_absent) return "";
  return "'" + word + "' must end in " + ending;
}

}  // namespace cs550::files
