#include "gradebook/command/gradescope_zip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "cli/system/process.hpp"
#include "cli/system/terminal.hpp"
#include "files/interruption.hpp"
#include "files/output_file.hpp"
#include "gradebook/command/grade.hpp"
#include "gradebook/command/settings.hpp"
#include "gradebook/run/work_folder.hpp"

namespace cs550::gradebook {

namespace fs = std::filesystem;

namespace {

/// Whether Gradescope, which names a student by address, names the one of an entry.
bool has_address(const std::string& entry, const std::vector<Student>& roster) {
  return entry.find('@') != std::string::npos ||
         std::any_of(roster.begin(), roster.end(), [&entry](const Student& student) {
           return is_about(entry, student) && !student.email.empty();
         });
}

void print_entries_without_effect(const Course& course, const std::vector<Student>& roster) {
  const auto check = [&roster](const char* table, const auto& entries) {
    for (const auto& entry : entries) {
      if (has_address(entry.student, roster)) continue;
      std::cout << cli::indented(
          fmt::format("[[{}]] of lab {} for {} has no effect: Gradescope knows addresses. Add "
                      "--roster with the address",
                      table, entry.lab, entry.student),
          0);
    }
  };
  check("extension", course.extensions);
  check("adjustment", course.adjustments);
  check("regrade", course.regrades);
}

}  // namespace

void make_gradescope_zip(const GradescopeRequest& request) {
  files::watch_for_interruption();
  const fs::path& out = request.out;
  if (const fs::path folder = fs::absolute(out).parent_path(); !fs::is_directory(folder)) {
    throw std::runtime_error("there is no folder " + folder.string() + " to write the zip to");
  }
  const Settings settings = read_settings(request.root, request.course, request.roster, {});
  std::vector<int> known;
  for (const auto& [number, lab] : settings.catalogue) known.push_back(number);
  std::string numbers;
  std::string targets = "grade_lab cs550_grade";
  const std::vector<int> labs = parse_labs(request.labs, known);
  check_starters(request.root, labs, settings.catalogue);
  check_starters_in_index(request.root, labs, settings.catalogue);
  for (const int number : labs) {
    numbers += fmt::format("{}{}", numbers.empty() ? "" : ",", number);
    targets += fmt::format(" lab{0}_judge lab{0}_stub_code", number);
    if (settings.course.lab(number).own_tests > 0) {
      targets += fmt::format(" lab{0}_own_tests mistakes_lab{0}", number);
    }
  }

  const WorkFolder stage(fs::temp_directory_path());
  cli::output_of({"git", "checkout-index", "--all", "--prefix=" + stage.path().string() + '/'},
                 request.root);
  for (const char* name : {"setup.sh", "run_autograder", "grade.sh"}) {
    fs::rename(stage.path() / "framework/gradebook/gradescope" / name, stage.path() / name);
  }
  files::write_file(stage.path() / "labs.txt", numbers + '\n');
  files::write_file(stage.path() / "targets.txt", targets + '\n');
  keep_settings(settings, stage.path());
  const WorkFolder packed(fs::temp_directory_path());
  const fs::path zip = packed.path() / "autograder.zip";
  cli::output_of({"cmake", "-E", "tar", "cf", zip.string(), "--format=zip", "."}, stage.path());
  files::throw_if_interrupted();
  files::copy_file(zip, out);
  std::cout << fmt::format(
      "{} is the autograder of --labs {}. Upload it to Gradescope, with Ubuntu 24.04 as its base "
      "image.\n"
      "It has the solutions: give it to nobody else.\n",
      out.string(), numbers);
  print_entries_without_effect(settings.course, settings.roster);
}

}  // namespace cs550::gradebook
