#include "gradebook/course/catalogue.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <regex>
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

/// Whether the code in a folder differs from Git's last commit. Not if Git cannot tell.
bool has_changes(const fs::path& folder) {
  const std::string but_own_tests = std::string(":(exclude,glob)**/") + own_tests_file;
  try {
    // With CS550_BUILD_DIR the root is a folder of links.
    return !cli::output_of({"git", "status", "--porcelain", "--untracked-files=all", "--",
                            ":(glob)**/*.cpp", ":(glob)**/*.hpp", but_own_tests},
                           fs::canonical(folder))
                .empty();
  } catch (const std::exception&) {
    return false;
  }
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
  for (const int number : labs) {
    const std::string& name = catalogue.at(number).name;
    if (!has_changes(root / "labs" / name)) continue;
    throw std::runtime_error(
        fmt::format("labs/{} differs from the starter; ./cs550 lab {} --reset restores it.\n"
                    "  Submissions would get its functions in place of those that they lack.",
                    name, number));
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
