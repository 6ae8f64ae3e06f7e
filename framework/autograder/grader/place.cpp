#include "autograder/grader/place.hpp"

#include <algorithm>
#include <regex>
#include <string>
#include <system_error>
#include <vector>

namespace cs550::grader {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

/// What is in a folder; nothing if it cannot be read.
Paths entries(const fs::path& folder) {
  std::error_code unreadable;
  Paths paths;
  fs::directory_iterator entry(folder, unreadable);
  for (; !unreadable && entry != fs::directory_iterator(); entry.increment(unreadable)) {
    paths.push_back(entry->path());
  }
  return paths;
}

/// The subfolders of a folder. Those behind links are found where they are.
Paths subfolders(const fs::path& folder) {
  Paths paths = entries(folder);
  std::erase_if(paths, [](const fs::path& path) {
    std::error_code absent;
    return !fs::is_directory(fs::symlink_status(path, absent));
  });
  return paths;
}

/// The folders in which an installation puts libraries: lib, lib64, lib/x86_64-linux-gnu, also in prefixes
/// such as local/ and local/cs550/.
Paths library_folders(const fs::path& system) {
  Paths prefixes{system, system / "local"};
  for (const fs::path& prefix : subfolders(system / "local")) prefixes.push_back(prefix);
  Paths libraries{system};  // /lib of a system in which it is no link
  for (const fs::path& prefix : prefixes) {
    for (const fs::path& folder : subfolders(prefix)) {
      if (!folder.filename().string().starts_with("lib")) continue;
      libraries.push_back(folder);
      for (const fs::path& of_machine : subfolders(folder)) libraries.push_back(of_machine);
    }
  }
  return libraries;
}

}  // namespace

bool is_seen_by_submissions(const fs::path& path) {
  return std::any_of(
      seen_by_submissions.begin(), seen_by_submissions.end(), [&path](const fs::path& folder) {
        return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
               folder.end();
      });
}

fs::path installed_engine(const fs::path& system) {
  static const std::regex name(R"(lib(cs550|lab\d+_(reference|fast))\.so(\.[\d.]+)?)");
  for (const fs::path& folder : library_folders(system)) {
    for (const fs::path& file : entries(folder)) {
      if (std::regex_match(file.filename().string(), name)) return file;
    }
  }
  return {};
}

}  // namespace cs550::grader
