#include "lab_files.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

#include "process.hpp"
#include "project.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;

namespace {

/// Texts by the names of their files.
using Texts = std::map<fs::path, std::string>;

fs::path lab_folder(const std::string& lab_name) { return project_root() / "labs" / lab_name; }

bool is_code(const fs::path& file) {
  return file.extension() == ".cpp" || file.extension() == ".hpp";
}

std::vector<fs::path> code_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::exists(folder)) return files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file() && is_code(entry.path())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Texts texts_in(const fs::path& folder) {
  Texts texts;
  for (const fs::path& file : code_in(folder)) texts[file.filename()] = read_text(file);
  return texts;
}

/// Throws std::runtime_error where git does not know the folder.
Texts committed_texts(const fs::path& folder) {
  const std::string tree = "HEAD:./" + fs::relative(folder, project_root()).string() + '/';
  std::istringstream names(output_of({"git", "ls-tree", "--name-only", tree}, project_root()));
  Texts texts;
  for (std::string name; std::getline(names, name);) {
    if (is_code(name)) texts[name] = output_of({"git", "show", tree + name}, project_root());
  }
  return texts;
}

Texts starter_of(const std::string& lab_name) {
  if (Texts pristine = texts_in(project_root() / ".starters" / lab_name); !pristine.empty()) {
    return pristine;
  }
  try {
    return committed_texts(lab_folder(lab_name));
  } catch (const std::exception&) {
    throw std::runtime_error("there is no starter of labs/" + lab_name +
                             ": neither .starters/ nor git has it");
  }
}

fs::path first_free_backup(const fs::path& file) {
  for (int n = 1;; ++n) {
    fs::path backup = file.string() + ".bak-" + std::to_string(n);
    if (!fs::exists(backup)) return backup;
  }
}

}  // namespace

std::vector<fs::path> lab_files(const std::string& lab_name) {
  return code_in(lab_folder(lab_name));
}

std::string fingerprint(const std::string& lab_name) {
  std::string sums;
  for (const fs::path& file : lab_files(lab_name)) sums += sha256(file);
  return sums;
}

bool is_untouched(const std::string& lab_name) {
  try {
    return texts_in(lab_folder(lab_name)) == starter_of(lab_name);
  } catch (const std::runtime_error&) {
    return false;
  }
}

std::vector<fs::path> reset_to_starter(const std::string& lab_name) {
  const Texts starter = starter_of(lab_name);
  const fs::path folder = lab_folder(lab_name);
  std::vector<fs::path> backups;
  for (const auto& [name, text] : texts_in(folder)) {
    const auto pristine = starter.find(name);
    if (pristine != starter.end() && pristine->second == text) continue;
    backups.push_back(first_free_backup(folder / name));
    fs::rename(folder / name, backups.back());
  }
  for (const auto& [name, text] : starter) {
    if (!fs::exists(folder / name)) write_text(folder / name, text);
  }
  return backups;
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
