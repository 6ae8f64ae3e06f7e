#include "gradebook/intake/lab_path.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <vector>

#include "files/source_name.hpp"
#include "gradebook/text/escape.hpp"

namespace cs550::gradebook {
namespace {

using Words = std::vector<std::string>;

Words split(std::string_view path) {
  Words words;
  std::string word;
  for (const char c : path) {
    if (c != '/' && c != '\\') {
      word += c;
      continue;
    }
    if (!word.empty() && word != ".") words.push_back(word);
    word.clear();
  }
  if (!word.empty()) words.push_back(word);
  return words;
}

std::string joined(Words::const_iterator begin, Words::const_iterator end) {
  std::string path;
  for (; begin != end; ++begin) path += (path.empty() ? "" : "/") + *begin;
  return path;
}

bool is_hidden(const std::string& file) { return file[0] == '.' || file.find("/.") != file.npos; }

/// The folders around that of the lab may have any names, in any encoding. Their length is limited, because an archive
/// may have many.
std::string fault_of_path(std::string_view path, const Words& words) {
  constexpr std::size_t longest = 4096;
  const bool has_drive = path.size() > 1 && path[1] == ':';
  if (path.empty() || words.empty()) return "empty name";
  if (path[0] == '/' || path[0] == '\\' || has_drive) return "absolute path";
  if (std::count(words.begin(), words.end(), "..") > 0) return "path with ..";
  if (path.size() > longest) return "path of more than 4096 bytes";
  return {};
}

/// @param file relative to the lab's folder
std::string fault_of_file(const std::string& file) {
  constexpr std::size_t longest = 200;
  if (file.size() > longest) return "name of more than 200 bytes";
  if (plain_line(file) != file) return "control characters or invalid UTF-8 in its name";
  if (is_hidden(file)) return "hidden file";
  if (!files::is_source(file)) {
    return "not a C++ source file (" + files::source_extensions() + ")";
  }
  if (!files::has_plain_name(file)) {
    return "a name of other characters than letters, digits and _-.";
  }
  return {};
}

/// The parts of a project that the instructor's copy provides, and what tools leave behind.
bool is_given_folder(const std::string& word) {
  static const std::set<std::string> given{".ci",   ".git",    ".starters", "__MACOSX",
                                           "build", "docs",    "framework", "solutions",
                                           "tests", ".vscode", ".idea",     "CMakeFiles"};
  return given.contains(word);
}

/// The end of the folders that may be a lab's: what is in a given folder is not the student's.
Words::const_iterator end_of_own_folders(const Words& words) {
  return std::find_if(words.begin(), words.end() - 1, is_given_folder);
}

std::string in_lower_case(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}

/// The lab whose folder is called so, such as "lab3_hill_climbing"; 0 if there is none.
int lab_of_name(const std::string& folder, const Catalogue& catalogue) {
  for (const auto& [number, lab] : catalogue) {
    if (in_lower_case(folder) == lab.name) return number;
  }
  return 0;
}

/// The lab of a folder "lab3" or "Lab3"; 0 if there is none.
int lab_of_number(const std::string& folder, const Catalogue& catalogue) {
  for (const auto& [number, lab] : catalogue) {
    if (in_lower_case(folder) == "lab" + std::to_string(number)) return number;
  }
  return 0;
}

/// By labs/lab3_hill_climbing, as in the student's own copy, whatever the folders around it and in it are called.
LabPath in_project(const Words& words, const Catalogue& catalogue) {
  const auto end = end_of_own_folders(words);
  for (auto word = words.begin(); word != end && word + 1 != end; ++word) {
    const int lab = *word == "labs" ? lab_of_name(word[1], catalogue) : 0;
    if (lab == 0 || word[1] != catalogue.at(lab).name) continue;
    return {lab, joined(word + 2, words.end()), "", true, joined(words.begin(), word)};
  }
  return {};
}

/// By the first folder that names a lab. A file manager unpacks lab3.zip into one more folder lab3: of such folders
/// directly in each other, the innermost is the lab's.
/// @param lab_of returns the number of the lab that a folder names, or 0
LabPath below_folder(const Words& words, const Catalogue& catalogue,
                     int (*lab_of)(const std::string&, const Catalogue&)) {
  const auto names_lab = [&](const std::string& word) { return lab_of(word, catalogue) != 0; };
  const auto end = end_of_own_folders(words);
  const auto first = std::find_if(words.begin(), end, names_lab);
  if (first == end) return {};
  const auto inside = std::find_if_not(first, end, names_lab);
  return {lab_of(*(inside - 1), catalogue), joined(inside, words.end()), "", false, ""};
}

/// By folder. A student rarely gives the full name of a lab's folder to another one, so it comes before a number.
LabPath below_lab_folder(const Words& words, const Catalogue& catalogue) {
  LabPath place = in_project(words, catalogue);
  if (place.lab == 0) place = below_folder(words, catalogue, lab_of_name);
  if (place.lab == 0) place = below_folder(words, catalogue, lab_of_number);
  return place;
}

/// By the name of a starter file that only one lab has.
LabPath named_like_starter(const Words& words, const Catalogue& catalogue) {
  LabPath found;
  if (std::any_of(words.begin(), words.end() - 1, is_given_folder)) return found;
  for (const auto& [number, lab] : catalogue) {
    if (std::count(lab.starter_files.begin(), lab.starter_files.end(), words.back()) == 0) continue;
    if (found.lab != 0) return {};
    found = {number, words.back(), "", false, ""};
  }
  return found;
}

LabPath ignored(const std::string& reason) {
  LabPath path;
  path.ignored = reason;
  return path;
}

}  // namespace

LabPath lab_path(std::string_view path, const Catalogue& catalogue) {
  const Words words = split(path);
  if (const std::string fault = fault_of_path(path, words); !fault.empty()) return ignored(fault);
  LabPath place = below_lab_folder(words, catalogue);
  if (place.lab == 0) place = named_like_starter(words, catalogue);
  if (place.lab == 0) return ignored(outside_of_labs);
  const std::string fault = fault_of_file(place.file);
  return fault.empty() ? place : ignored(fault);
}

}  // namespace cs550::gradebook
