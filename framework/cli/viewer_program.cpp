#include "viewer_program.hpp"

#include "project.hpp"

namespace cs550::cli {

bool has_viewer() { return CS550_HAS_VIEWER; }

std::vector<std::string> viewer_command(bool student, const std::string& preset) {
  const bool only_student = std::filesystem::exists(project_root() / ".starters");
  const bool is_student = student || only_student;
  const std::string program = is_student ? "cs550_viewer_student" : "cs550_viewer";
  if (!build(preset, program)) return {};
  std::vector<std::string> command{built_program(preset, program)};
  if (is_student) command.emplace_back("--student");
  return command;
}

}  // namespace cs550::cli
