#include "cli/system/viewer.hpp"

#include "cli/system/project.hpp"

namespace cs550::cli {

std::vector<std::string> viewer_command(bool student) {
  const bool is_student = student || is_students_copy();
  const std::string program = is_student ? "cs550_viewer_student" : "cs550_viewer";
  // A student alternates between editing and looking: the preset that rebuilds quickly.
  const std::string preset = is_student ? "student" : "release";
  if (!build(preset, program)) return {};
  std::vector<std::string> command{built_program(preset, program)};
  if (is_student) command.emplace_back("--student");
  return command;
}

}  // namespace cs550::cli
