#include "students_copy.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "lab_files.hpp"
#include "process.hpp"
#include "project.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

/// Beside solutions and hidden tests: what needs the reference, or is about making this repository.
constexpr const char* instructors_only[] = {
    ".ci",          "CONTRIBUTING.md",    "tests/autograder", "tests/cli",
    "tests/engine", "tests/milestones",   "tests/mutants",    "tests/benchmarks",
    "tests/viewer", "docs/instructors.md"};
constexpr const char* students_readme = "framework/cli/students_readme.md";
constexpr const char* file_list = ".starters/files.txt";
constexpr const char* version_file = ".starters/version.txt";

/// Only what is committed: a lab file that an instructor tried something in is nobody's starter.
void unpack_commit(const fs::path& folder) {
  const fs::path archive = folder / "commit.tar";
  try {
    output_of({"git", "archive", "--format=tar", "-o", archive, "HEAD"}, project_root());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("the students' copy is made from a git commit. " +
                             std::string(error.what()));
  }
  output_of({"cmake", "-E", "tar", "xf", archive}, folder);
  constexpr std::size_t digits = 12;
  const std::string version = sha256(archive).substr(0, digits);
  fs::remove(archive);
  fs::create_directories(folder / ".starters");
  write_text(folder / version_file, version + '\n');
}

/// The entries of a folder, by name; none when it is absent.
std::vector<fs::path> entries(const fs::path& folder) {
  std::vector<fs::path> paths;
  if (fs::exists(folder)) {
    for (const auto& entry : fs::directory_iterator(folder)) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

bool is_released(const fs::path& solution, int released) {
  for (int lab = 1; lab <= released; ++lab) {
    if (solution.filename().string().rfind("lab" + std::to_string(lab) + '_', 0) == 0) return true;
  }
  return false;
}

void remove_solutions(const fs::path& folder, int released) {
  for (const fs::path& solution : entries(folder / "solutions")) {
    if (!is_released(solution, released)) fs::remove_all(solution);
  }
  if (entries(folder / "solutions").empty()) fs::remove(folder / "solutions");
}

void remove_hidden_tests(const fs::path& folder) {
  for (const fs::path& lab : entries(folder / "tests")) {
    fs::remove_all(lab / "hidden");
    const fs::path manifest = lab / "manifest.json";
    if (!fs::exists(manifest)) continue;
    Json json = Json::parse(read_text(manifest));
    Json visible = Json::array();
    for (const Json& test : json.at("tests")) {
      if (!test.at("hidden")) visible.push_back(test);
    }
    json["tests"] = visible;
    write_text(manifest, json.dump(2) + '\n');
  }
}

void keep_starters(const fs::path& folder) {
  for (const fs::path& lab : entries(folder / "labs")) {
    for (const fs::path& file : entries(lab)) {
      if (file.extension() != ".cpp") continue;
      fs::create_directories(folder / ".starters" / lab.filename());
      fs::copy_file(file, folder / ".starters" / lab.filename() / file.filename());
    }
  }
}

void list_files(const fs::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_directory()) files.push_back(fs::relative(entry.path(), folder));
  }
  std::sort(files.begin(), files.end());
  std::string text;
  for (const std::string& file : files) text += file + '\n';
  write_text(folder / file_list, text);
}

bool is_lab_file(const fs::path& path) {
  return *path.begin() == "labs" && path.extension() == ".cpp";
}

fs::path starter_of(const fs::path& lab_file) {
  return fs::path(".starters") / lab_file.lexically_relative("labs");
}

bool same_text(const fs::path& a, const fs::path& b) {
  return fs::exists(a) && fs::exists(b) && read_text(a) == read_text(b);
}

/// In one move, so that an interrupted update leaves no half of a file.
void replace(const fs::path& file, const fs::path& fresh) {
  fs::create_directories(file.parent_path());
  const fs::path draft = file.string() + ".new";
  fs::copy_file(fresh, draft, fs::copy_options::overwrite_existing);
  fs::rename(draft, file);
}

}  // namespace

void write_students_copy(const fs::path& folder, int released) {
  unpack_commit(folder);
  remove_solutions(folder, released);
  remove_hidden_tests(folder);
  fs::rename(folder / students_readme, folder / "README.md");
  for (const char* path : instructors_only) fs::remove_all(folder / path);
  keep_starters(folder);
  list_files(folder);
}

void start_history(const fs::path& folder) {
  output_of({"git", "init", "-q", "--initial-branch=main", "--template="}, folder);
  output_of({"git", "add", "--all"}, folder);
  output_of({"git", "-c", "user.name=CS550", "-c", "user.email=cs550@localhost", "-c",
             "commit.gpgSign=false", "commit", "-q", "-m", "The seven labs"},
            folder);
}

std::vector<std::string> files_of_copy(const fs::path& copy) {
  std::istringstream lines(read_text(copy / file_list));
  std::vector<std::string> files;
  for (std::string line; std::getline(lines, line);) files.push_back(line);
  return files;
}

CopyUpdate update_copy(const fs::path& copy, const fs::path& fresh) {
  const std::vector<std::string> old_files = files_of_copy(copy);
  const std::vector<std::string> new_files = files_of_copy(fresh);
  CopyUpdate update;
  // Lab files first: whether one was changed is told from the old starters.
  for (const std::string& file : new_files) {
    if (!is_lab_file(file)) continue;
    if (!fs::exists(copy / file) || same_text(copy / file, copy / starter_of(file))) {
      replace(copy / file, fresh / file);
    } else {
      update.kept.push_back(file);
      if (!same_text(copy / starter_of(file), fresh / starter_of(file))) {
        update.conflicts.push_back(file);
      }
    }
  }
  for (const std::string& file : new_files) {
    if (is_lab_file(file) || same_text(copy / file, fresh / file)) continue;
    replace(copy / file, fresh / file);
    ++update.files_replaced;
  }
  for (const std::string& file : old_files) {
    if (!is_lab_file(file) && !std::binary_search(new_files.begin(), new_files.end(), file)) {
      fs::remove(copy / file);
      ++update.files_replaced;
    }
  }
  replace(copy / file_list, fresh / file_list);
  return update;
}

}  // namespace cs550::cli
