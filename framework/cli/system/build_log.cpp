#include "cli/system/build_log.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <initializer_list>

#include "cli/system/project.hpp"

namespace cs550::cli {

namespace {

std::ifstream open_log() { return std::ifstream(project_root() / "build/student.log"); }

/// The compiler starts in the build folder: "../../labs/..." becomes "labs/...". Without a compiler
/// cache it is called with absolute paths.
std::string from_the_root(const std::string& line) {
  const std::string root = project_root().string() + '/';
  if (line.rfind(root, 0) == 0) return line.substr(root.size());
  const std::size_t start = line.find_first_not_of("./");
  return line[0] == '.' && start != std::string::npos ? line.substr(start) : line;
}

bool has_any(const std::string& line, std::initializer_list<const char*> texts) {
  const auto is_in_line = [&](const char* text) { return line.find(text) != std::string::npos; };
  return std::any_of(texts.begin(), texts.end(), is_in_line);
}

/// Whether ninja reports its progress, "[12/65] Building ...", or its own end.
bool is_of_ninja(const std::string& line) {
  const bool counts = line.starts_with('[') && std::isdigit(line[1]) != 0;
  return counts || line.starts_with("ninja: ");
}

/// Whether a compiler only repeats that its linker has failed.
bool repeats_a_failure(const std::string& line) {
  return has_any(line, {"error: ld returned ", "error: linker command failed "});
}

/// What the first failed step of the build printed; without one, the last line of the log. Other steps that are
/// running then end later, and may also fail.
std::vector<std::string> failed_step() {
  std::ifstream lines = open_log();
  std::vector<std::string> step;
  bool has_failed = false;
  for (std::string line; std::getline(lines, line);) {
    const bool fails = line.starts_with("FAILED: ");
    if (has_failed && (fails || is_of_ninja(line))) break;
    if (line.empty() || line.starts_with("ninja: build stopped") || repeats_a_failure(line))
      continue;
    if (!has_failed) step.clear();
    if (fails) {
      has_failed = true;
      std::getline(lines, line);  // the command line
    } else {
      step.push_back(line);
    }
  }
  return step;
}

bool is_of_the_linker(const std::string& error) {
  return has_any(error, {"undefined reference to", "multiple definition of"});
}

bool is_error(const std::string& line) {
  return has_any(line, {"error: "}) || is_of_the_linker(line);
}

/// Whether the compiler itself failed, perhaps at a place in the code.
bool is_of_the_compiler(const std::string& error) {
  return has_any(error, {"error: error writing to ", "error: opening dependency file ",
                         "internal compiler error: ", " signal terminated program ",
                         "error: unable to execute command: "});
}

/// Whether a line reports that a lab uses a template.
bool uses_a_template(const std::string& line) {
  return has_any(line, {"required from", "requested here"}) && has_any(line, {"labs/"});
}

}  // namespace

std::string first_build_error() {
  const std::vector<std::string> lines = failed_step();
  if (lines.empty()) return "the build failed";
  const auto error = std::find_if(lines.begin(), lines.end(), is_error);
  return from_the_root(error != lines.end() ? *error : lines.back());
}

bool is_students_error(const std::string& error) {
  if (!is_error(error) || is_of_the_compiler(error)) return false;
  if (error.starts_with("labs/") || is_of_the_linker(error)) return true;
  const std::vector<std::string> lines = failed_step();
  return std::any_of(lines.begin(), lines.end(), uses_a_template);
}

std::vector<std::string> own_warnings() {
  std::ifstream lines = open_log();
  std::vector<std::string> warnings;
  for (std::string line; std::getline(lines, line);) {
    if (line.find(": warning: ") == std::string::npos) continue;
    const std::string warning = from_the_root(line);
    const bool is_known = std::find(warnings.begin(), warnings.end(), warning) != warnings.end();
    if (warning.rfind("labs/", 0) == 0 && !is_known) warnings.push_back(warning);
  }
  return warnings;
}

std::string build_progress() {
  std::ifstream lines = open_log();
  std::string counter;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t end = line.find(']');
    const bool counts = line.rfind('[', 0) == 0 && line.rfind("[0/", 0) != 0;
    if (counts && end != std::string::npos) counter = line.substr(0, end + 1);
  }
  return counter;
}

}  // namespace cs550::cli
