#include "cli/system/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "cli/system/process.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;

std::string read_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::exists(folder)) return files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string sha256(const fs::path& file) {
  constexpr std::size_t digits = 64;
  return output_of({"cmake", "-E", "sha256sum", file}).substr(0, digits);
}

std::string fingerprint_of(const std::vector<fs::path>& files) {
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&hash](std::string_view bytes) {
    for (const char byte : bytes) {
      hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    }
  };
  for (const fs::path& file : files) {
    add(file.native());
    add(read_text(file));
  }
  return fmt::format("{:016x}", hash);
}

// Not by mkdtemp(), whose folder is closed to others: the wanted one follows the umask.
DraftFolder::DraftFolder(const fs::path& wanted) {
  fs::create_directories(wanted.parent_path());
  const std::string start = wanted.string() + ".partial-" + std::to_string(getpid());
  path_ = start;
  for (int i = 1; !fs::create_directory(path_); ++i) path_ = start + '-' + std::to_string(i);
}

DraftFolder::~DraftFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace cs550::cli
