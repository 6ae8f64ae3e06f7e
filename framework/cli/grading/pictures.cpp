#include "cli/grading/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "cli/system/process.hpp"
#include "cli/system/project.hpp"
#include "files/output_file.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* png_converter = "rsvg-convert";

fs::path pictures_folder() { return project_root() / "build/results/pictures"; }

fs::path png_of(const fs::path& picture) { return fs::path(picture).replace_extension(".png"); }

std::string full_name(int lab, const GradedTest& test) {
  return fmt::format("Lab{}.{}", lab, test.name);
}

/// Another program may have the same name.
bool can_convert() {
  try {
    return output_of({png_converter, "--version"}).rfind(png_converter, 0) == 0;
  } catch (const std::runtime_error&) {
    return false;
  }
}

/// Prints in this copy for the first time how to have PNG files, too.
void advise_png_once() {
  const fs::path advised = project_root() / "build/results/advised_png";
  if (fs::exists(advised)) return;
  std::cout << "./cs550 doctor --install picture also saves pictures as PNG.\n";
  files::write_file(advised, "");
}

}  // namespace

fs::path picture_of(const std::string& test) { return pictures_folder() / (test + ".svg"); }

std::vector<std::string> tests_with_pictures() {
  std::vector<std::string> tests;
  std::error_code absent;
  for (const auto& entry : fs::directory_iterator(pictures_folder(), absent)) {
    if (entry.path().extension() == ".svg") tests.push_back(entry.path().stem());
  }
  std::sort(tests.begin(), tests.end());
  return tests;
}

void remove_picture(int lab, const GradedTest& test) {
  const fs::path picture = picture_of(full_name(lab, test));
  fs::remove(picture);
  fs::remove(png_of(picture));
}

void finish_pictures(int lab, const std::vector<Verdict>& verdicts) {
  std::string first_step;
  for (const Verdict& verdict : verdicts) {
    const std::string& step = verdict.test.step;
    const bool is_first = first_step.empty() || is_earlier_step(step, first_step);
    if (verdict.kind == Verdict::Kind::Failed && is_first) first_step = step;
  }
  std::vector<std::string> tests;
  for (const Verdict& verdict : verdicts) {
    const std::string test = full_name(lab, verdict.test);
    const bool is_reported =
        verdict.kind == Verdict::Kind::Failed && verdict.test.step == first_step;
    if (is_reported && fs::exists(picture_of(test))) tests.push_back(test);
  }
  if (tests.empty()) return;
  std::cout << "See the failing case from all sides:\n  ./cs550 view --failure " << tests.front()
            << std::endl;
  if (!can_convert()) return advise_png_once();
  for (const std::string& test : tests) {
    run({png_converter, "--output", png_of(picture_of(test)), picture_of(test)});
  }
}

}  // namespace cs550::cli
