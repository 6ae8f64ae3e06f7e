#include "gradebook/course/catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "cli/system/files.hpp"
#include "cli/system/process.hpp"
#include "cli/system/project.hpp"

namespace cs550::gradebook {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::vector<CatalogueTest> tests_of(const fs::path& manifest, int lab) {
  std::vector<CatalogueTest> tests;
  try {
    const Json json = Json::parse(cli::read_text(manifest));
    for (const Json& test : json.at("tests")) {
      tests.push_back({fmt::format("Lab{}.{}", lab, test.at("name").get<std::string>()),
                       test.at("step"), test.at("points"), test.at("hidden")});
    }
  } catch (const Json::exception& error) {
    throw std::runtime_error(manifest.string() + " is damaged: " + error.what() +
                             "\n  ./cs550 build test update_manifests regenerates it.");
  }
  return tests;
}

std::vector<std::string> code_below(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::path& file : cli::files_below(folder)) {
    if (file.filename() == own_tests_file) continue;
    if (file.extension() == ".cpp" || file.extension() == ".hpp") {
      names.push_back(file.lexically_relative(folder).string());
    }
  }
  return names;
}

std::vector<std::string> milestones_of(const fs::path& records, int lab) {
  std::vector<std::string> names;
  for (const fs::path& file : cli::files_below(records)) {
    const std::string name = file.stem();
    if (name.starts_with(fmt::format("lab{}_", lab))) names.push_back("Milestone." + name);
  }
  return names;
}

/// The folder of the project. With CS550_BUILD_DIR the root is a folder of links.
fs::path project_of(const fs::path& root) { return fs::canonical(root / "labs").parent_path(); }

/// Files with code of a lab that are in Git's answer to a question, relative to the folder that it is asked in.
/// @throws std::exception if Git cannot tell
std::set<std::string> code_in_answer(const fs::path& project, const fs::path& folder,
                                     const std::string& lab,
                                     const std::vector<std::string>& question) {
  // Lets Git read a clone that another user made, such as one that is mounted in a container.
  std::vector<std::string> command{"git", "-c", "safe.directory=" + project.string(), "-c",
                                   "core.fileMode=false"};
  command.insert(command.end(), question.begin(), question.end());
  const std::string lab_folder = (project / "labs" / lab).lexically_relative(folder);
  const std::string code = ":(glob)" + lab_folder + "/**/*";
  command.insert(command.end(), {"--", code + ".cpp", code + ".hpp",
                                 std::string(":(exclude,glob)**/") + own_tests_file});
  static const std::regex name_of_code(R"(.*\.[ch]pp"?)");  // other lines are warnings
  std::set<std::string> names;
  std::istringstream lines(cli::output_of(command, folder));
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, name_of_code)) names.insert(line);
  }
  return names;
}

/// Files with code of a lab that differ from Git's last commit. Only their contents count, not Git's index.
std::set<std::string> changed_code(const fs::path& project, const std::string& lab) {
  const fs::path folder = project / "labs" / lab;
  std::set<std::string> names =
      code_in_answer(project, folder, lab, {"ls-files", "--others", "--exclude-standard"});
  names.merge(code_in_answer(project, folder, lab, {"diff", "--relative", "--name-only", "HEAD"}));
  return names;
}

/// "a.cpp, b.cpp, c.cpp and 4 more".
std::string first_of(const std::set<std::string>& names) {
  constexpr std::size_t most = 3;
  const std::size_t shown = std::min(most, names.size());
  const auto end = std::next(names.begin(), static_cast<std::ptrdiff_t>(shown));
  const std::string list = fmt::format("{}", fmt::join(names.begin(), end, ", "));
  return shown == names.size() ? list : fmt::format("{} and {} more", list, names.size() - shown);
}

/// What is wrong with a lab whose code differs from the starter, and how to mend it.
std::string refusal(const std::string& lab, int number, const std::set<std::string>& changed) {
  std::set<std::string> deeper;
  std::copy_if(changed.begin(), changed.end(), std::inserter(deeper, deeper.end()),
               [](const std::string& name) { return name.find('/') != std::string::npos; });
  std::string text = fmt::format(
      "labs/{} differs from the starter: {}.\n"
      "  Submissions would get what they lack from it; copies of it would be missed.",
      lab, first_of(changed));
  if (deeper.size() < changed.size()) {
    text += fmt::format("\n  ./cs550 lab {} --reset restores the starter and keeps your files.",
                        number);
  }
  if (!deeper.empty()) {
    text += fmt::format("\n  Move files in its subfolders elsewhere: {}.", first_of(deeper));
  }
  return text;
}

}  // namespace

Catalogue read_catalogue(const fs::path& root) {
  static const std::regex lab_folder("lab([0-9]{1,3})_[a-z0-9_]+");
  Catalogue catalogue;
  for (const fs::directory_entry& entry : fs::directory_iterator(root / "tests")) {
    const std::string name = entry.path().filename();
    std::smatch match;
    const fs::path manifest = entry.path() / "manifest.json";
    if (!std::regex_match(name, match, lab_folder) || !fs::exists(manifest)) continue;
    const int number = std::stoi(match[1]);
    catalogue[number] = {number,
                         0,
                         name,
                         cli::title(name),
                         tests_of(manifest, number),
                         code_below(root / "labs" / name),
                         milestones_of(root / "framework/assets/trajectories", number)};
  }
  return catalogue;
}

void check_starters(const fs::path& root, const std::vector<int>& labs,
                    const Catalogue& catalogue) {
  const fs::path project = project_of(root);
  for (const int number : labs) {
    const std::string& name = catalogue.at(number).name;
    std::set<std::string> changed;
    try {
      changed = changed_code(project, name);
    } catch (const std::exception& error) {
      if (!fs::exists(project / ".git")) return;
      const std::string reason = error.what();
      std::cerr << "cannot check that labs/ has the starters: "
                << reason.substr(0, reason.find('\n')) << '\n';
      return;
    }
    if (!changed.empty()) throw std::runtime_error(refusal(name, number, changed));
  }
}

void check_starters_in_index(const fs::path& root, const std::vector<int>& labs,
                             const Catalogue& catalogue) {
  const fs::path project = project_of(root);
  for (const int number : labs) {
    const std::string& name = catalogue.at(number).name;
    const std::set<std::string> changed =
        code_in_answer(project, project, name, {"diff", "--name-only", "--cached", "HEAD"});
    if (changed.empty()) continue;
    throw std::runtime_error(
        fmt::format("Git's index does not have the starter of lab {}: {}.\n"
                    "  The autograder would have it. To mend that: git restore --staged labs/{}",
                    number, first_of(changed), name));
  }
}

CatalogueLab engine_of(const Catalogue& catalogue, int last) {
  CatalogueLab engine;
  engine.last = last;
  for (const auto& [number, lab] : catalogue) {
    if (number > last) continue;
    for (const std::string& milestone : lab.milestones) {
      engine.tests.push_back({milestone, fmt::format("L{}", number), 0, false});
    }
  }
  return engine;
}

}  // namespace cs550::gradebook
