#include "cli/system/build_log.hpp"

#include <algorithm>
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

/// Whether the compiler itself failed, at a place in the code.
bool is_of_the_compiler(const std::string& error) {
  return has_any(error, {"error: error writing to ", "error: opening dependency file ",
                         "internal compiler error: "});
}

/// Whether a line reports a mistake of a lab outside of the lab's files: in a template that it uses, or in what it
/// defines.
bool is_of_a_lab(const std::string& line) {
  const bool uses_a_template = has_any(line, {"required from", "requested here"});
  return (uses_a_template && has_any(line, {"labs/"})) ||
         has_any(line, {"undefined reference to", "multiple definition of"});
}

}  // namespace

std::string first_build_error() {
  std::ifstream lines = open_log();
  std::string last = "the build failed";
  std::string tolerated;  // of another lab, which counts as empty
  bool has_failed = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("FAILED: ", 0) == 0) has_failed = true;
    if (line.find("error: ") != std::string::npos) {
      if (has_failed) return from_the_root(line);
      if (tolerated.empty()) tolerated = from_the_root(line);
    }
    if (!line.empty() && !line.starts_with("ninja: build stopped")) last = line;
  }
  return has_failed || tolerated.empty() ? last : tolerated;
}

bool is_students_error(const std::string& error) {
  if (error.starts_with("labs/")) return !is_of_the_compiler(error);
  if (error.find("error: ") == std::string::npos) return false;  // of CMake, or out of memory
  std::ifstream lines = open_log();
  for (std::string line; std::getline(lines, line);) {
    if (is_of_a_lab(line)) return true;
  }
  return false;
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
