#include "gradebook/command/gradescope_zip.hpp"

#include <fmt/format.h>

#include <iostream>
#include <stdexcept>

#include "cli/system/files.hpp"
#include "cli/system/process.hpp"
#include "files/output_file.hpp"
#include "gradebook/command/grade.hpp"
#include "gradebook/course/course_file.hpp"
#include "gradebook/run/work_folder.hpp"

namespace cs550::gradebook {

namespace fs = std::filesystem;

void make_gradescope_zip(const fs::path& root, const std::string& labs, const fs::path& course,
                         const fs::path& out) {
  if (const fs::path folder = fs::absolute(out).parent_path(); !fs::is_directory(folder)) {
    throw std::runtime_error("there is no folder " + folder.string() + " to write the zip to");
  }
  const Catalogue catalogue = read_catalogue(root);
  const std::string text = course.empty() ? "" : cli::read_text(course);
  const Course settings = parse_course(text, course.string(), catalogue);
  std::vector<int> known;
  for (const auto& [number, lab] : catalogue) known.push_back(number);
  std::string numbers;
  std::string targets = "grade_lab cs550_grade";
  for (const int number : parse_labs(labs, known)) {
    numbers += fmt::format("{}{}", numbers.empty() ? "" : ",", number);
    targets += fmt::format(" lab{}_judge", number);
    if (settings.lab(number).own_tests > 0) {
      targets += fmt::format(" lab{0}_own_tests mistakes_lab{0}", number);
    }
  }

  const WorkFolder stage(fs::temp_directory_path());
  cli::output_of({"git", "checkout-index", "--all", "--prefix=" + stage.path().string() + '/'},
                 root);
  for (const char* name : {"setup.sh", "run_autograder", "grade.sh"}) {
    fs::rename(stage.path() / "framework/gradebook/gradescope" / name, stage.path() / name);
  }
  files::write_file(stage.path() / "labs.txt", numbers + '\n');
  files::write_file(stage.path() / "targets.txt", targets + '\n');
  if (!course.empty()) files::write_file(stage.path() / "course.toml", text);
  fs::remove(out);
  cli::output_of({"cmake", "-E", "tar", "cf", fs::absolute(out).string(), "--format=zip", "."},
                 stage.path());
  std::cout << fmt::format(
      "{} is the autograder of --labs {}. Upload it to Gradescope, with Ubuntu 24.04 as its base "
      "image.\n"
      "It has the solutions: give it to nobody else.\n",
      out.string(), numbers);
}

}  // namespace cs550::gradebook
