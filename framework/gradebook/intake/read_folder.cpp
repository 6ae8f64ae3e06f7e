#include "gradebook/intake/read_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <vector>

namespace cs550::gradebook {
namespace {

namespace fs = std::filesystem;

/// Up to one byte more than the limit; nothing if the file cannot be read.
bool read_content(const fs::path& file, std::size_t most, std::string& content) {
  std::ifstream stream(file, std::ios::binary);
  content.resize(most + 1);
  stream.read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<std::size_t>(stream.gcount()));
  content.shrink_to_fit();
  return stream.eof() || content.size() > most;
}

/// @return the bytes that were taken
std::size_t offer(const fs::path& file, const fs::path& folder, Collector& collector,
                  std::size_t most) {
  const std::string path = file.lexically_relative(folder).string();
  const fs::file_status status = fs::symlink_status(file);
  if (fs::is_symlink(status)) {
    collector.ignore(path, "symbolic link");
  } else if (!fs::is_regular_file(status)) {
    collector.ignore(path, "neither a file nor a folder");
  } else if (collector.wants(path)) {
    std::string content;
    if (read_content(file, most, content)) {
      const std::size_t size = content.size();
      collector.take(path, std::move(content));
      return size;
    }
    collector.ignore(path, "cannot be read");
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
