#include "cli/grading/lab_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>

#include "cli/system/files.hpp"
#include "cli/system/process.hpp"
#include "cli/system/project.hpp"
#include "files/output_file.hpp"
#include "files/source_name.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;

namespace {

/// Texts by the names of their files.
using Texts = std::map<fs::path, std::string>;

fs::path lab_folder(const std::string& lab_name) { return project_root() / "labs" / lab_name; }

/// Tests that the student has written are neither graded here nor reset.
bool is_students_test(const fs::path& file) { return file.filename() == "my_tests.cpp"; }

bool is_code(const fs::path& file) {
  return !is_students_test(file) && (file.extension() == ".cpp" || file.extension() == ".hpp");
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
  const std::string tree = "HEAD:./" + folder.lexically_relative(project_root()).string() + '/';
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
    throw std::runtime_error("no starter of labs/" + lab_name +
                             " was found, neither in .starters/ nor in git's last commit");
  }
}

fs::path first_free_backup(const fs::path& file) {
  for (int n = 1;; ++n) {
    fs::path backup = file.string() + ".bak-" + std::to_string(n);
    if (!fs::exists(backup)) return backup;
  }
}

/// Throws std::runtime_error where the solution is absent.
Texts solution_of(const std::string& lab_name) {
  Texts solution = texts_in(project_root() / "solutions" / lab_name);
  if (!solution.empty()) return solution;
  throw std::runtime_error(
      fmt::format("lab {} has no solution here: solutions/{} is missing.\n"
                  "  Your instructor decides when it is released.",
                  lab_number(lab_name), lab_name));
}

/// Puts other files in the place of the student's. Those that differ are kept.
/// @return the backups; nothing if the files are the same already
std::optional<std::vector<fs::path>> replace_lab_files(const std::string& lab_name,
                                                       const Texts& fresh) {
  const fs::path folder = lab_folder(lab_name);
  const Texts former = texts_in(folder);
  if (former == fresh) return std::nullopt;
  std::vector<fs::path> backups;
  for (const auto& [name, text] : former) {
    const auto same = fresh.find(name);
    if (same != fresh.end() && same->second == text) continue;
    backups.push_back(first_free_backup(folder / name));
    files::write_file(backups.back(), text);
    fs::permissions(backups.back(), fs::status(folder / name).permissions());
    if (same == fresh.end()) fs::remove(folder / name);
  }
  for (const auto& [name, text] : fresh) files::write_file(folder / name, text);
  return backups;
}

bool is_given(const fs::path& file) {
  return file.filename() == "README.md" || file.extension() == ".svg";
}

/// Of --reset or of an editor: a.cpp.bak-1, a.cpp~, #a.cpp#.
bool is_backup(const fs::path& file) {
  const std::string& name = file.native();
  return file.extension().native().starts_with(".bak-") || name.ends_with('~') ||
         name.ends_with('#');
}

/// Those that a student may have written. Hidden ones are left out: a name in their path begins with a dot.
std::vector<fs::path> students_files(const std::string& lab_name) {
  const fs::path folder = lab_folder(lab_name);
  std::vector<fs::path> files = files_below(folder);
  std::erase_if(files, [&](const fs::path& file) {
    const fs::path name = file.lexically_relative(folder);
    const bool is_hidden = std::any_of(name.begin(), name.end(), [](const fs::path& part) {
      return part.native().starts_with('.');
    });
    return is_hidden || is_given(file) || is_backup(file);
  });
  return files;
}

bool is_handed_in(const std::string& lab_name, const fs::path& file) {
  return files::is_source(file) &&
         files::has_plain_name(file.lexically_relative(lab_folder(lab_name)));
}

void append(std::vector<fs::path>& files, const std::vector<fs::path>& more) {
  files.insert(files.end(), more.begin(), more.end());
}

/// What every graded program is built from.
const std::vector<fs::path>& given_files() {
  static const std::vector<fs::path> files = [] {
    std::vector<fs::path> all;
    for (const char* folder : {"framework", "tests/helpers", "tests/fixtures"}) {
      append(all, files_below(project_root() / folder));
    }
    return all;
  }();
  return files;
}

}  // namespace

std::vector<fs::path> lab_files(const std::string& lab_name) {
  std::vector<fs::path> files = students_files(lab_name);
  std::erase_if(files, is_students_test);
  return files;
}

std::vector<fs::path> files_to_submit(const std::string& lab_name) {
  std::vector<fs::path> files = students_files(lab_name);
  std::erase_if(files, [&](const fs::path& file) { return !is_handed_in(lab_name, file); });
  return files;
}

std::vector<fs::path> files_left_out(const std::string& lab_name) {
  std::vector<fs::path> files = students_files(lab_name);
  std::erase_if(files, [&](const fs::path& file) { return is_handed_in(lab_name, file); });
  return files;
}

bool has_reference(const std::string& lab_name) {
  return fs::exists(project_root() / "solutions" / lab_name);
}

std::string fingerprint(const std::string& lab_name) {
  std::vector<fs::path> files = given_files();
  append(files, files_below(project_root() / "tests" / lab_name));
  append(files, files_below(project_root() / "solutions"));
  for (const std::string& other : lab_names()) {
    const bool is_earlier = lab_number(other) < lab_number(lab_name);
    if (other == lab_name || (is_earlier && !has_reference(other))) append(files, lab_files(other));
  }
  return fingerprint_of(files);
}

std::string fault_of_absent_code(const std::string& lab_name) {
  const std::vector<fs::path> code = code_in(lab_folder(lab_name));
  if (std::any_of(code.begin(), code.end(),
                  [](const fs::path& file) { return file.extension() == ".cpp"; })) {
    return "";
  }
  return fmt::format(
      "labs/{} has no .cpp file. ./cs550 lab {} --reset\nputs the starter there again.", lab_name,
      lab_number(lab_name));
}

bool is_untouched(const std::string& lab_name) {
  try {
    return texts_in(lab_folder(lab_name)) == starter_of(lab_name);
  } catch (const std::runtime_error&) {
    return false;
  }
}

bool is_nothing_to_submit(const std::string& lab_name) {
  return is_untouched(lab_name) &&
         files_to_submit(lab_name).size() == code_in(lab_folder(lab_name)).size();
}

std::optional<std::vector<fs::path>> reset_to_starter(const std::string& lab_name) {
  return replace_lab_files(lab_name, starter_of(lab_name));
}

std::optional<std::vector<fs::path>> use_solution(const std::string& lab_name) {
  return replace_lab_files(lab_name, solution_of(lab_name));
}

}  // namespace cs550::cli
