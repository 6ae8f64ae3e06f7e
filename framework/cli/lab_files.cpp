#include "lab_files.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "process.hpp"
#include "project.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;

namespace {

/// labs/lab3_hill_climbing/hill_climbing.cpp, seen from the root.
fs::path path_in_project(const std::string& lab_name) {
  const std::string topic = lab_name.substr(lab_name.find('_') + 1);
  return fs::path("labs") / lab_name / (topic + ".cpp");
}

fs::path first_free_backup(const fs::path& file) {
  for (int n = 1;; ++n) {
    fs::path backup = file.string() + ".bak-" + std::to_string(n);
    if (!fs::exists(backup)) return backup;
  }
}

}  // namespace

fs::path lab_file(const std::string& lab_name) {
  return project_root() / path_in_project(lab_name);
}

std::string starter_text(const std::string& lab_name) {
  const fs::path path = path_in_project(lab_name);
  const fs::path pristine = project_root() / ".starters" / path.lexically_relative("labs");
  if (fs::exists(pristine)) return read_text(pristine);
  try {
    return output_of({"git", "show", "HEAD:./" + path.string()}, project_root());
  } catch (const std::exception&) {
    throw std::runtime_error("there is no starter of " + path.string() +
                             ": neither .starters/ nor git has it");
  }
}

bool is_untouched(const std::string& lab_name) {
  try {
    return read_text(lab_file(lab_name)) == starter_text(lab_name);
  } catch (const std::runtime_error&) {
    return false;
  }
}

fs::path reset_to_starter(const std::string& lab_name) {
  const fs::path file = lab_file(lab_name);
  const std::string starter = starter_text(lab_name);
  fs::path backup;
  if (fs::exists(file)) {
    if (read_text(file) == starter) return {};
    backup = first_free_backup(file);
    fs::copy_file(file, backup);
  }
  write_text(file, starter);
  return backup;
}

bool has_newer_file(const fs::path& folder, fs::file_time_type time) {
  const auto files = fs::recursive_directory_iterator(folder);
  return std::any_of(begin(files), end(files), [time](const fs::directory_entry& entry) {
    return entry.is_regular_file() && entry.last_write_time() > time;
  });
}

std::string read_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write_text(const fs::path& file, const std::string& text) {
  const fs::path draft = file.string() + ".new" + std::to_string(getpid());
  std::ofstream stream(draft, std::ios::binary);
  stream << text << std::flush;
  std::error_code error;
  if (stream) fs::rename(draft, file, error);
  if (!stream || error) {
    std::error_code ignored;
    fs::remove(draft, ignored);
    throw std::runtime_error("cannot write " + file.string());
  }
}

std::string sha256(const fs::path& file) {
  constexpr std::size_t digits = 64;
  return output_of({"cmake", "-E", "sha256sum", file}).substr(0, digits);
}

}  // namespace cs550::cli
