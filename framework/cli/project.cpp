#include "project.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "process.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;

fs::path project_root() {
  if (const char* root = std::getenv("CS550_ROOT")) return root;
  for (fs::path folder = fs::current_path(); folder != folder.root_path();
       folder = folder.parent_path()) {
    if (fs::exists(folder / "framework/cli/verbs.def")) return folder;
  }
  throw std::runtime_error("run ./cs550, or start this program inside the repository");
}

int lab_number(const std::string& lab_name) { return std::stoi(lab_name.substr(3)); }

std::vector<std::string> lab_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(project_root() / "tests")) {
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

bool build(const std::string& preset, const std::string& target) {
  return run({project_root() / "cs550", "build", preset, target}).exit_code == 0;
}

fs::path built_program(const std::string& preset, const std::string& name) {
  return project_root() / "build" / preset / "bin" / name;
}

}  // namespace cs550::cli
