#include "cli/system/project.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <stdexcept>

#include "cli/system/build_log.hpp"
#include "cli/system/process.hpp"
#include "cli/system/terminal.hpp"
#include "cs550/excerpt.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;

fs::path project_root() {
  if (const char* root = std::getenv("CS550_ROOT")) return root;
  for (fs::path folder = fs::current_path(); folder != folder.root_path();
       folder = folder.parent_path()) {
    if (fs::exists(folder / "framework/cli/verbs.def")) return folder;
  }
  throw std::runtime_error(fs::current_path().string() +
                           " is not inside the repository: run ./cs550 there");
}

fs::path behind_links(const fs::path& root) { return fs::canonical(root / "cs550").parent_path(); }

bool has_uncommitted_changes(const fs::path& root) {
  // Git takes what is behind a link as removed.
  return !output_of({"git", "status", "--porcelain", "--untracked-files=no"}, behind_links(root))
              .empty();
}

int lab_number(const std::string& lab_name) { return std::stoi(lab_name.substr(3)); }

std::vector<std::string> lab_names() {
  std::vector<std::string> names;
  const fs::path tests = project_root() / "tests";
  std::error_code unreadable;
  fs::directory_iterator entries(tests, unreadable);
  if (unreadable) {
    throw std::runtime_error(tests.string() + ": " + unreadable.message() +
                             ". CS550_ROOT must be the project's folder; ./cs550 sets it.");
  }
  for (const auto& entry : entries) {
    const std::string name = entry.path().filename();
    if (name.rfind("lab", 0) == 0 && name.size() > 3 && std::isdigit(name[3]) != 0) {
      names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end(), [](const std::string& a, const std::string& b) {
    return lab_number(a) < lab_number(b);
  });
  return names;
}

std::string lab_name(int number) {
  for (const std::string& name : lab_names()) {
    if (lab_number(name) == number) return name;
  }
  return {};
}

std::string title(const std::string& lab_name) {
  const std::size_t topic = lab_name.find('_');
  std::string title = "Lab " + lab_name.substr(3, topic - 3) + ": " + lab_name.substr(topic + 1);
  std::replace(title.begin(), title.end(), '_', ' ');
  return title;
}

std::string plain_lab_number(const std::string& typed) {
  static const std::regex spelling("(?:L|lab)?0?([1-9][0-9]?)", std::regex::icase);
  std::smatch found;
  return std::regex_match(typed, found, spelling) ? found.str(1) : typed;
}

std::string fault_of_lab_number(const std::string& word) {
  std::string fault = "there is no lab " + excerpt(word) + ". The labs:";
  for (const std::string& lab : lab_names()) {
    if (std::to_string(lab_number(lab)) == word) return {};
    fault.append("\n  ").append(title(lab));
  }
  return fault;
}

int lab_number_of_step(const std::string& step) { return std::stoi(step.substr(1)); }

std::string lab_of_step(const std::string& step) { return lab_name(lab_number_of_step(step)); }

bool is_students_copy() { return fs::exists(project_root() / ".starters"); }

std::string starter_version(const fs::path& copy) {
  std::ifstream file(copy / starter_version_file);
  std::string version;
  std::getline(file, version);
  return version;
}

fs::path draft_result(const std::string& name) {
  const fs::path folder = project_root() / "build/results";
  fs::create_directories(folder);
  return folder / ("draft." + name + '.' + std::to_string(getpid()));
}

bool build(const std::string& preset, const std::string& target) {
  return run({project_root() / "cs550", "build", preset, target}).exit_code == 0;
}

std::string build_quietly(const std::string& target) {
  const fs::path output = draft_result(target + "_log");
  StatusLine status;
  const Surroundings surroundings{
      {}, output, [&] {
        status.show([&] { return "Building " + target + ' ' + build_progress(); });
        return false;
      }};
  const Ending ending = run({project_root() / "cs550", "build", "student", target}, surroundings);
  fs::remove(output);
  return ending.good() ? "" : first_build_error();
}

fs::path built_program(const std::string& preset, const std::string& name) {
  return project_root() / "build" / preset / "bin" / name;
}

}  // namespace cs550::cli
