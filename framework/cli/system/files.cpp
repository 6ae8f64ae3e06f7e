#include "cli/system/files.hpp"

#include <fmt/format.h>

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
    std::ifstream stream(file, std::ios::binary);
    if (!stream) continue;  // an editor has removed it meanwhile
    add(file.native());
    add(std::string(std::istreambuf_iterator<char>(stream), {}));
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace cs550::cli
