#include "files/path_argument.hpp"

#include <sys/stat.h>

#include <cerrno>

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

}  // namespace cs550::files
