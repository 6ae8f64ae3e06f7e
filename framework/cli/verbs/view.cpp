// ./cs550 view: builds the viewer and becomes it. The viewer parses the rest of the command line.
#include "cli/verbs/view.hpp"

#include <algorithm>

#include "cli/system/process.hpp"
#include "cli/system/project.hpp"
#include "cli/verb.hpp"

namespace cs550::cli {

bool has_viewer() { return CS550_HAS_VIEWER; }

std::vector<std::string> viewer_command(bool student, const std::string& preset) {
  const bool is_student = student || is_students_copy();
  const std::string program = is_student ? "cs550_viewer_student" : "cs550_viewer";
  if (!build(preset, program)) return {};
  std::vector<std::string> command{built_program(preset, program)};
  if (is_student) command.emplace_back("--student");
  return command;
}

Action declare_view(CLI::App& app) {
  app.set_help_flag();  // --help goes to the viewer, which has the options
  app.allow_extras();
  return [&app] {
    std::vector<std::string> arguments = app.remaining();
    const auto student = std::find(arguments.begin(), arguments.end(), "--student");
    const bool wants_student = student != arguments.end();
    if (wants_student) arguments.erase(student);
    // A student alternates between editing and looking: the preset that rebuilds quickly.
    std::vector<std::string> command =
        viewer_command(wants_student, wants_student ? "student" : "release");
    if (command.empty()) return static_cast<int>(Failed);
    command.insert(command.end(), arguments.begin(), arguments.end());
    become(command);
  };
}

}  // namespace cs550::cli
