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
  return stream.eof() || content.size() > most;
}

void offer(const fs::path& file, const fs::path& folder, Collector& collector, std::size_t most) {
  const std::string path = file.lexically_relative(folder).string();
  const fs::file_status status = fs::symlink_status(file);
  if (fs::is_symlink(status)) {
    collector.ignore(path, "symbolic link");
  } else if (!fs::is_regular_file(status)) {
    collector.ignore(path, "neither a file nor a folder");
  } else if (collector.wants(path)) {
    std::string content;
    if (read_content(file, most, content)) {
      collector.take(path, std::move(content));
    } else {
      collector.ignore(path, "cannot be read");
    }
  }
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
  for (const fs::path& file : files) offer(file, folder, collector, limits.file);
  return "";
}

}  // namespace cs550::gradebook
