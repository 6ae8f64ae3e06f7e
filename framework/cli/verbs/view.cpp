// ./cs550 view: builds the viewer and becomes it. The viewer parses the rest of the command line.
#include <algorithm>
#include <iostream>

#include "cli/system/process.hpp"
#include "cli/system/project.hpp"
#include "cli/system/viewer.hpp"
#include "cli/verb.hpp"

namespace cs550::cli {

namespace {

/// The word after --lab; empty if there is none.
std::string lab_asked_for(const std::vector<std::string>& arguments) {
  const std::string option = "--lab";
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].rfind(option + "=", 0) == 0) return arguments[i].substr(option.size() + 1);
    if (arguments[i] == option && i + 1 < arguments.size()) return arguments[i + 1];
  }
  return {};
}

}  // namespace

Action declare_view(CLI::App& app) {
  app.set_help_flag();  // --help goes to the viewer, which has the options
  app.allow_extras();
  return [&app] {
    std::vector<std::string> arguments = app.remaining();
    // The viewer checks its options itself, but it may take a minute to build.
    if (const std::string lab = lab_asked_for(arguments); !lab.empty()) {
      if (const std::string fault = fault_of_lab_number(lab); !fault.empty()) {
        std::cerr << "cs550: " << fault << '\n';
        return static_cast<int>(Misused);
      }
    }
    const auto student = std::find(arguments.begin(), arguments.end(), "--student");
    const bool wants_student = student != arguments.end();
    if (wants_student) arguments.erase(student);
    std::vector<std::string> command = viewer_command(wants_student);
    if (command.empty()) return static_cast<int>(Failed);
    command.insert(command.end(), arguments.begin(), arguments.end());
    become(command);
  };
}

}  // namespace cs550::cli
