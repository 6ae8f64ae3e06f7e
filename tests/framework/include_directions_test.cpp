/// Includes between the folders of framework/ point one way, as the architecture chapter of the
/// book describes.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

const fs::path root = fs::path(CS550_TEST_DATA).parent_path().parent_path();
const fs::path framework = root / "framework";

/// For each folder of framework/, the other folders that its files may include from. `include` is
/// the contract.
const std::map<std::string, Names> may_include{
    {"include", {}},
    {"engine", {"include"}},
    {"drawing", {"include", "files"}},
    {"files", {"include"}},
    {"serialisation", {"include"}},
    {"isolation", {"serialisation"}},
    {"pages", {"include", "drawing", "serialisation", "isolation"}},
    {"viewer", {"include", "drawing", "pages", "files"}},
    // engine: only grader/, whose judge lets another process run the substeps of a world; milestones:
    // only the judge of the milestones
    {"autograder", {"include", "engine", "files", "serialisation", "isolation", "milestones"}},
    {"milestones", {"include", "files"}},
    {"gradebook", {"files", "cli"}},  // only cli/system, and its program cli/command_line
    {"cli", {"include", "files"}},
};

/// Libraries that only one folder may use.
const std::map<std::string, std::string> only_user_of{
    {"epoxy/", "viewer"}, {"GLFW/", "viewer"}, {"EGL/", "viewer"}, {"imgui/", "viewer"}};

struct Include {
  fs::path file;     ///< absolute
  int line = 0;      ///< in that file
  std::string what;  ///< between the quotes or brackets
  bool quoted = false;

  std::string place() const {
    return fs::relative(file, root).string() + ':' + std::to_string(line) + ": #include " + what;
  }
};

std::vector<Include> all_includes() {
  const std::regex directive(R"(^\s*#include\s*(["<])([^">]+)[">])");
  std::vector<Include> includes;
  for (const fs::path& file : fs::recursive_directory_iterator(framework)) {
    if (file.extension() != ".cpp" && file.extension() != ".hpp") continue;
    std::ifstream stream(file);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
      ++number;
      std::smatch match;
      if (!std::regex_search(line, match, directive)) continue;
      includes.push_back({file, number, match[2], match[1] == "\""});
    }
  }
  return includes;
}

/// The included file, or nothing if it is not in framework/.
fs::path resolved(const Include& include) {
  for (const fs::path& folder : {include.file.parent_path(), framework, framework / "include",
                                 framework / "autograder/include"}) {
    const fs::path candidate = (folder / include.what).lexically_normal();
    if (fs::exists(candidate)) return candidate;
  }
  return {};
}

std::string top_folder(const fs::path& file) { return *file.lexically_relative(framework).begin(); }

TEST(IncludeDirections, EveryFolderIncludesOnlyFromThoseBelowIt) {
  const std::vector<Include> includes = all_includes();
  EXPECT_GT(includes.size(), 500U) << "the files of framework/ were not found";
  for (const Include& include : includes) {
    const std::string from = top_folder(include.file);
    ASSERT_TRUE(may_include.contains(from))
        << "framework/" << from << " is new: add what it may include to " << __FILE__;
    for (const auto& [library, user] : only_user_of) {
      EXPECT_TRUE(!include.what.starts_with(library) || from == user)
          << include.place() << "\n  only framework/" << user << " may use " << library;
    }
    if (!include.quoted || include.what == "lab_functions.inc") continue;  // written by the build
    const fs::path target = resolved(include);
    if (target.empty()) {
      ADD_FAILURE() << include.place() << "\n  is not in framework/, which includes nothing from "
                    << "labs/, solutions/ or tests/";
      continue;
    }
    const std::string to = top_folder(target);
    EXPECT_TRUE(from == to || may_include.at(from).contains(to))
        << include.place() << "\n  framework/" << from << " may not include from framework/" << to
        << "; move the code that both need to the lower folder";
    EXPECT_NE(target.extension(), ".cpp") << include.place();
  }
}

/// For each folder, the folders that it includes from, with one include as the reason.
using FolderGraph = std::map<fs::path, std::map<fs::path, std::string>>;

FolderGraph folder_graph() {
  FolderGraph graph;
  for (const Include& include : all_includes()) {
    if (!include.quoted || include.what == "lab_functions.inc") continue;  // written by the build
    const fs::path target = resolved(include);
    const fs::path from = include.file.parent_path();
    const fs::path to = target.parent_path();
    if (target.empty() || from == to) continue;
    graph[from].emplace(to, include.place());
  }
  return graph;
}

/// Whether includes lead from one folder to another.
bool leads_to(const FolderGraph& graph, const fs::path& from, const fs::path& to, Names& seen) {
  if (from == to) return true;
  const auto arrows = graph.find(from);
  if (arrows == graph.end() || !seen.insert(from).second) return false;
  return std::any_of(arrows->second.begin(), arrows->second.end(),
                     [&](const auto& arrow) { return leads_to(graph, arrow.first, to, seen); });
}

TEST(IncludeDirections, NoTwoFoldersIncludeEachOther) {
  const FolderGraph graph = folder_graph();
  for (const auto& [from, arrows] : graph) {
    for (const auto& [to, reason] : arrows) {
      Names seen;
      EXPECT_FALSE(leads_to(graph, to, from, seen))
          << reason << "\n  closes a circle: " << fs::relative(to, root) << " leads back to "
          << fs::relative(from, root);
    }
  }
}

}  // namespace
