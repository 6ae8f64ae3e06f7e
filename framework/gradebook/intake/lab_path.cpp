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

std::string fault_of_name(std::string_view path, const Words& words) {
  constexpr std::size_t longest = 200;
  const bool has_drive = path.size() > 1 && path[1] == ':';
  if (path.empty() || words.empty()) return "empty name";
  if (path[0] == '/' || path[0] == '\\' || has_drive) return "absolute path";
  if (std::count(words.begin(), words.end(), "..") > 0) return "path with ..";
  if (path.size() > longest) return "name of more than 200 bytes";
  if (plain_line(path) != path) return "control characters or invalid UTF-8 in its name";
  return {};
}

/// The parts of a project that the instructor's copy provides, and what tools leave behind.
bool is_given_folder(const std::string& word) {
  static const std::set<std::string> given{".ci",   ".git",    ".starters", "__MACOSX",
                                           "build", "docs",    "framework", "solutions",
                                           "tests", ".vscode", ".idea",     "CMakeFiles"};
  return given.contains(word);
}

/// "lab3_hill_climbing", "lab3" and "Lab3" name lab 3.
bool names_lab(std::string word, const CatalogueLab& lab) {
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word == lab.name || word == "lab" + std::to_string(lab.number);
}

/// By folder. The words before it must not be a folder of the project.
LabPath below_lab_folder(const Words& words, const Catalogue& catalogue) {
  for (auto word = words.begin(); word + 1 < words.end() && !is_given_folder(*word); ++word) {
    for (const auto& [number, lab] : catalogue) {
      if (!names_lab(*word, lab)) continue;
      LabPath found{number, joined(word + 1, words.end()), "", false, ""};
      if (word != words.begin() && *(word - 1) == "labs" && *word == lab.name) {
        found.is_in_project = true;
        found.project = joined(words.begin(), word - 1);
      }
      return found;
    }
  }
  return {};
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

bool is_hidden(const std::string& file) { return file[0] == '.' || file.find("/.") != file.npos; }

LabPath ignored(const std::string& reason) {
  LabPath path;
  path.ignored = reason;
  return path;
}

}  // namespace

LabPath lab_path(std::string_view path, const Catalogue& catalogue) {
  const Words words = split(path);
  if (const std::string fault = fault_of_name(path, words); !fault.empty()) return ignored(fault);
  LabPath place = below_lab_folder(words, catalogue);
  if (place.lab == 0) place = named_like_starter(words, catalogue);
  if (place.lab == 0) return ignored(outside_of_labs);
  if (is_hidden(place.file)) return ignored("hidden file");
  if (!files::is_source(place.file)) {
    return ignored("not a C++ source file (" + files::source_extensions() + ")");
  }
  if (!files::has_plain_name(place.file)) {
    return ignored("a name of other characters than letters, digits and _-.");
  }
  return place;
}

}  // namespace cs550::gradebook
