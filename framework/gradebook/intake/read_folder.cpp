#include "gradebook/intake/read_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace cs550::gradebook {
namespace {

namespace fs = std::filesystem;

/// Up to one byte more than the limit.
/// @param path of the file in the submission
/// @throws std::runtime_error if it cannot be read
std::string content_of(const fs::path& file, const std::string& path, std::size_t most) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::string content(most + 1, '\0');
  stream.read(content.data(), static_cast<std::streamsize>(content.size()));
  if (!stream && !stream.eof()) {
    throw std::runtime_error(path + " cannot be read: " + std::generic_category().message(errno));
  }
  content.resize(static_cast<std::size_t>(stream.gcount()));
  content.shrink_to_fit();
  return content;
}

/// @return the bytes that were taken
/// @throws std::runtime_error if a file that is wanted cannot be read: the starter must not take its place
std::size_t offer(const fs::path& file, const fs::path& folder, Collector& collector,
                  std::size_t most) {
  const std::string path = file.lexically_relative(folder).string();
  const fs::file_status status = fs::symlink_status(file);
  if (fs::is_symlink(status)) {
    collector.ignore(path, "symbolic link");
  } else if (!fs::is_regular_file(status)) {
    collector.ignore(path, "neither a file nor a folder");
  } else if (collector.wants(path)) {
    std::string content = content_of(file, path, most);
    const std::size_t size = content.size();
    collector.take(path, std::move(content));
    return size;
  }
  return 0;
}

}  // namespace

std::string read_folder(const fs::path& folder, Collector& collector, const IntakeLimits& limits) {
  std::error_code error;
  int entries = 0;
  std::vector<fs::path> files;
  fs::recursive_directory_iterator entry(folder, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (++entries > limits.entries) {
      return fmt::format("the folder has more than {} entries", limits.entries);
    }
    const bool is_folder = fs::is_directory(entry->symlink_status(error));
    if (!is_folder) files.push_back(entry->path());
    if (is_folder && entry->path().filename() == ".git") entry.disable_recursion_pending();
  }
  if (error) return "the folder cannot be read: " + error.message();
  std::sort(files.begin(), files.end());  // the record must not depend on the order of a directory
  std::size_t taken = 0;
  for (const fs::path& file : files) {
    taken += offer(file, folder, collector, limits.file);
    if (taken > limits.unpacked) {
      return fmt::format("the folder has files of more than {} MB", limits.unpacked >> 20U);
    }
  }
  return "";
}

}  // namespace cs550::gradebook
