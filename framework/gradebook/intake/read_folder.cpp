#include "gradebook/intake/read_folder.hpp"

#include <fmt/format.h>

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

}  // namespace

std::string read_folder(const fs::path& folder, Collector& collector, const IntakeLimits& limits) {
  std::error_code error;
  int entries = 0;
  fs::recursive_directory_iterator entry(folder, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (++entries > limits.entries) {
      return fmt::format("the folder has more than {} entries", limits.entries);
    }
    const std::string path = entry->path().lexically_relative(folder).string();
    const fs::file_status status = entry->symlink_status(error);
    if (fs::is_directory(status)) {
      if (entry->path().filename() == ".git") entry.disable_recursion_pending();
    } else if (fs::is_symlink(status)) {
      collector.ignore(path, "symbolic link");
    } else if (!fs::is_regular_file(status)) {
      collector.ignore(path, "neither a file nor a folder");
    } else if (collector.wants(path)) {
      std::string content;
      if (read_content(entry->path(), limits.file, content)) {
        collector.take(path, std::move(content));
      } else {
        collector.ignore(path, "cannot be read");
      }
    }
  }
  return error ? "the folder cannot be read: " + error.message() : "";
}

}  // namespace cs550::gradebook
