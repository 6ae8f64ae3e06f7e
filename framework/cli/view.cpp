// ./cs550 view: builds the viewer and becomes it. The viewer reads the rest of the command line.
#include <algorithm>

#include "process.hpp"
#include "verb.hpp"
#include "viewer_program.hpp"

namespace cs550::cli {

Action declare_view(CLI::App& app) {
  app.set_help_flag();  // the viewer has the list
  app.allow_extras();
  return [&app] {
    std::vector<std::string> arguments = app.remaining();
    const auto student = std::find(arguments.begin(), arguments.end(), "--student");
    const bool wants_student = student != arguments.end();
    if (wants_student) arguments.erase(student);
    // A student edits and looks, again and again: the preset that rebuilds quickly.
    std::vector<std::string> command =
        viewer_command(wants_student, wants_student ? "student" : "release");
    if (command.empty()) return static_cast<int>(Failed);
    command.insert(command.end(), arguments.begin(), arguments.end());
    become(command);
  };
}

}  // namespace cs550::cli
