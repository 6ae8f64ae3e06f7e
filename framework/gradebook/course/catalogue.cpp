#include "gradebook/course/catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
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

/// Files with code of a lab that differ from Git's last commit, relative to the lab's folder. Only their contents
/// count, not Git's index. @throws std::exception if Git cannot tell
std::vector<std::string> changed_code(const fs::path& project, const std::string& lab) {
  using Words = std::vector<std::string>;
  // Lets Git read a clone that another user made, such as one that is mounted in a container.
  const Words git{"env", "GIT_CONFIG_COUNT=1", "GIT_CONFIG_KEY_0=safe.directory",
                  "GIT_CONFIG_VALUE_0=" + project.string(), "git"};
  const Words code{"--", ":(glob)**/*.cpp", ":(glob)**/*.hpp",
                   std::string(":(exclude,glob)**/") + own_tests_file};
  std::vector<std::string> names;
  for (const Words& question :
       {Words{"ls-files", "--others", "--exclude-standard"},
        Words{"-c", "core.fileMode=false", "diff", "--relative", "--name-only", "HEAD"}}) {
    Words command = git;
    command.insert(command.end(), question.begin(), question.end());
    command.insert(command.end(), code.begin(), code.end());
    std::istringstream lines(cli::output_of(command, project / "labs" / lab));
    for (std::string name; std::getline(lines, name);) names.push_back(name);
  }
  return names;
}

/// "a.cpp, b.cpp, c.cpp and 4 more".
std::string first_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 3;
  const std::size_t shown = std::min(most, names.size());
  const auto end = names.begin() + static_cast<std::ptrdiff_t>(shown);
  const std::string list = fmt::format("{}", fmt::join(names.begin(), end, ", "));
  return shown == names.size() ? list : fmt::format("{} and {} more", list, names.size() - shown);
}

/// What is wrong with a lab whose code differs from the starter, and how to mend it.
std::string refusal(const std::string& lab, int number, const std::vector<std::string>& changed) {
  std::vector<std::string> deeper;
  std::copy_if(changed.begin(), changed.end(), std::back_inserter(deeper),
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
    std::vector<std::string> changed;
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
