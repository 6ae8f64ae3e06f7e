#include "gradebook/course/course_dates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include "gradebook/course/course_file.hpp"

namespace cs550::gradebook {
namespace {

/// An entry is about a student in capitals or not.
std::string lower(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name;
}

}  // namespace

void check_dates(const Course& course, const std::string& file) {
  for (const auto& [number, lab] : course.labs) {
    if (!lab.due || !lab.solution_released || *lab.solution_released >= *lab.due) continue;
    throw CourseError(
        fmt::format("{}: [lab.{}]: solution_released is before due, so that nobody "
                    "could earn points up to the due date",
                    file, number));
  }
  std::set<std::pair<std::string, int>> known;
  for (const Extension& extension : course.extensions) {
    const auto refuse = [&](const char* why) {
      throw CourseError(fmt::format("{}: [[extension]] of lab {} for {}: {}", file, extension.lab,
                                    extension.student, why));
    };
    const LabSettings lab = course.lab(extension.lab);
    if (!known.emplace(lower(extension.student), extension.lab).second) {
      refuse("the student has another one; keep the one that counts");
    }
    if (lab.due && extension.due < *lab.due) refuse("it ends before the lab's due date");
    if (lab.solution_released && extension.due > *lab.solution_released) {
      refuse("it ends after solution_released, and what comes later earns nothing");
    }
  }
}

}  // namespace cs550::gradebook
