// ./cs550 view: builds the viewer and becomes it. The viewer parses the rest of the command line.
#include <fmt/format.h>

#include <algorithm>

#include "cli/command_line.hpp"
#include "cli/grading/pictures.hpp"
#include "cli/system/process.hpp"
#include "cli/system/project.hpp"
#include "cli/system/viewer.hpp"
#include "cli/verb.hpp"
#include "cs550/excerpt.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

/// The value of an option; null if it is not among the words. "--lab=4" becomes two words.
std::string* value_of(Words& words, const std::string& option) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i].rfind(option + '=', 0) == 0) {
      const std::string value = words[i].substr(option.size() + 1);
      words[i] = option;
      words.insert(words.begin() + static_cast<std::ptrdiff_t>(i) + 1, value);
    }
    if (words[i] == option && i + 1 < words.size()) return &words[i + 1];
  }
  return nullptr;
}

/// The failing tests that have a picture, on one screen.
std::string existing_pictures() {
  constexpr std::size_t most = 20;
  const Words tests = tests_with_pictures();
  if (tests.empty()) {
    return ".\n  ./cs550 lab N draws one where a picture helps, and then prints this command.";
  }
  std::string list = ". These are:";
  for (std::size_t i = 0; i < std::min(most, tests.size()); ++i) list += "\n  " + tests[i];
  if (tests.size() > most) list += fmt::format("\nand {} more", tests.size() - most);
  return list;
}

/// What is wrong with the name of a failing test; empty if it has a picture.
std::string fault_of_failure(const std::string& test) {
  std::error_code no_such_file;
  if (fs::exists(picture_of(test), no_such_file)) return {};
  return "there is no picture of a failing test " + excerpt(test) + existing_pictures();
}

int misuse(const std::string& fault) {
  print_error(fault);
  return Misused;
}

}  // namespace

Action declare_view(CLI::App& app) {
  app.set_help_flag();  // --help goes to the viewer, which has the options
  app.allow_extras();
  return [&app] {
    Words arguments = app.remaining();
    // The viewer checks its options itself, but it may take a minute to build.
    if (const std::string* lab = value_of(arguments, "--lab")) {
      if (const std::string fault = fault_of_lab_number(*lab); !fault.empty()) return misuse(fault);
    }
    if (std::string* test = value_of(arguments, "--failure")) {
      if (const std::string fault = fault_of_failure(*test); !fault.empty()) return misuse(fault);
      *test = picture_of(*test);
    } else if (!arguments.empty() && arguments.back() == "--failure") {
      return misuse("--failure needs the name of a failing test that has a picture" +
                    existing_pictures());
    }
    const auto student = std::find(arguments.begin(), arguments.end(), "--student");
    const bool wants_student = student != arguments.end();
    if (wants_student) arguments.erase(student);
    Words command = viewer_command(wants_student);
    if (command.empty()) return static_cast<int>(Failed);
    command.insert(command.end(), arguments.begin(), arguments.end());
    become(command);
  };
}

}  // namespace cs550::cli
