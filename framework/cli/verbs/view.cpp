// ./cs550 view: builds the viewer and becomes it. The viewer parses the rest of the command line.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <sstream>

#include "cli/command_line.hpp"
#include "cli/grading/pictures.hpp"
#include "cli/system/process.hpp"
#include "cli/system/project.hpp"
#include "cli/system/viewer.hpp"
#include "cli/system/viewer_options.hpp"
#include "cli/verb.hpp"
#include "cs550/excerpt.hpp"
#include "files/path_argument.hpp"
#include "files/usage_fault.hpp"

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

bool is_number(const std::string& word) {
  char* end = nullptr;
  std::strtof(word.c_str(), &end);
  return !word.empty() && *end == '\0';
}

std::string fault_of_camera(const std::string& text) {
  std::istringstream list(text);
  std::size_t count = 0;
  for (std::string word; std::getline(list, word, ','); ++count) {
    if (!is_number(word)) return "--camera: '" + excerpt(word) + "' is not a number";
  }
  return count == 2 || count == 3 || count == 6
             ? ""
             : "--camera needs 2, 3 or 6 numbers, as in --camera=-60,20,8";
}

std::string fault_of_ending(const std::string& option, const std::string& file,
                            const std::string& ending) {
  const std::string fault = files::fault_of_ending(file, ending);
  return fault.empty() ? "" : option + ": " + fault;
}

std::string fault_of_scene(const std::string& name) {
  const char* assets = std::getenv("CS550_ASSETS");
  const fs::path scenes =
      (assets != nullptr ? fs::path(assets) : project_root() / "framework/assets") / "scenes";
  std::error_code none;
  if (fs::exists(scenes / (name + ".json"), none) || fs::exists(name, none)) return "";
  return "there is no scene \"" + excerpt(name) + "\"\nGive the path of a scene file or one in " +
         scenes.string();
}

bool is_option(const std::string& word) {
  return word.size() > 1 && word.front() == '-' && word != "--";
}

/// The viewer's option that a word names, as in "--lab" and "--lab=4"; null if there is none.
const files::Argument* option_of(const std::string& word) {
  const auto found = std::find_if(
      viewer_options.begin(), viewer_options.end(),
      [name = word.substr(0, word.find('='))](const auto& option) { return option.name == name; });
  return found == viewer_options.end() ? nullptr : &*found;
}

/// Whether the next word is the value of this one.
bool takes_next_word(const std::string& word) {
  const files::Argument* option = option_of(word);
  return option != nullptr && !option->value.empty() && word.find('=') == std::string::npos;
}

bool lacks_value(const Words& words, std::size_t option) {
  const std::size_t equals = words[option].find('=');
  if (equals != std::string::npos) return equals + 1 == words[option].size();
  return option + 1 == words.size() || words[option + 1].rfind("--", 0) == 0;
}

std::string fault_of_option(const Words& words, std::size_t place) {
  const std::string& word = words[place];
  const files::Argument* option = option_of(word);
  if (option == nullptr) return files::usage_fault({"", viewer_options, {word}});
  if (option->value.empty()) return word == option->name ? "" : option->name + " takes no value";
  if (!lacks_value(words, place)) return "";
  return files::usage_fault({option->name + ": 1 required value missing", viewer_options, {}});
}

/// The first fault of an option; empty if there is none.
std::string fault_of_options(const Words& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!is_option(words[i])) continue;
    if (const std::string fault = fault_of_option(words, i); !fault.empty()) return fault;
    if (takes_next_word(words[i])) ++i;
  }
  return "";
}

/// The first word that is neither an option nor the value of one; null if there is none.
const std::string* scene_of(const Words& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (takes_next_word(words[i])) {
      ++i;
    } else if (!is_option(words[i]) && words[i] != "--") {
      return &words[i];
    }
  }
  return nullptr;
}

/// The first wrong value that is found without the viewer; empty if there is none.
std::string fault_of_values(Words words) {
  std::string fault;
  if (const std::string* lab = value_of(words, "--lab")) fault = fault_of_lab_number(*lab);
  if (const std::string* camera = value_of(words, "--camera"); camera && fault.empty()) {
    fault = fault_of_camera(*camera);
  }
  if (const std::string* file = value_of(words, "--snapshot"); file && fault.empty()) {
    fault = fault_of_ending("--snapshot", *file, ".png");
  }
  if (const std::string* file = value_of(words, "--gif"); file && fault.empty()) {
    fault = fault_of_ending("--gif", *file, ".gif");
  }
  const std::string* scene = scene_of(words);
  return scene && fault.empty() ? fault_of_scene(*scene) : fault;
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
    if (std::string* lab = value_of(arguments, "--lab")) *lab = plain_lab_number(*lab);
    // The viewer checks its options itself, but it may take minutes to build.
    if (!arguments.empty() && arguments.back() == "--failure") {
      return misuse("--failure needs the name of a failing test that has a picture" +
                    existing_pictures());
    }
    if (const std::string fault = fault_of_options(arguments); !fault.empty()) {
      misuse(fault);
      std::cerr << "./cs550 view --help explains the options.\n";
      return static_cast<int>(Misused);
    }
    if (const std::string fault = fault_of_values(arguments); !fault.empty()) return misuse(fault);
    if (std::string* test = value_of(arguments, "--failure")) {
      if (const std::string fault = fault_of_failure(*test); !fault.empty()) return misuse(fault);
      *test = picture_of(*test);
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
