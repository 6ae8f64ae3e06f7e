#include "gradebook/marks/dates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ratio>

#include "gradebook/course/course_file.hpp"
#include "gradebook/marks/time_text.hpp"

namespace cs550::gradebook {

std::optional<Time> time_of_submission(const Student& student, const Record& record,
                                       const Course& course) {
  switch (course.late ? course.late->clock : Clock::File) {
    case Clock::File:
      if (!record.file_time) return std::nullopt;
      return Time(std::chrono::seconds(*record.file_time));
    case Clock::Manifest:
      return parse_time(record.claimed_date);
    case Clock::Roster:
      return student.submitted;
  }
  return std::nullopt;
}

const Extension* extension_of(const Student& student, int lab, const Course& course) {
  for (const Extension& extension : course.extensions) {
    if (is_about(extension.student, student) && extension.lab == lab) return &extension;
  }
  return nullptr;
}

void check_extensions(const Course& course, const std::vector<Student>& roster) {
  for (const Student& student : roster) {
    for (const Extension& extension : course.extensions) {
      if (!is_about(extension.student, student)) continue;
      const Extension* first = extension_of(student, extension.lab, course);
      if (first == &extension) continue;
      throw CourseError(fmt::format(
          "[[extension]] of lab {} for {} and for {} are about one student of the roster; keep the "
          "one that counts",
          extension.lab, first->student, extension.student));
    }
  }
}

Time coarse_time(Time time, const std::vector<int>& labs, const Student& student,
                 const Course& course) {
  using namespace std::chrono;
  Time end = sys_days(year(2100) / January / 1);
  if (!course.late) return end;
  const auto shorten = [&](Time date) {
    if (date >= time) end = std::min(end, date);
  };
  for (const int lab : labs) {
    const LabSettings settings = course.lab(lab);
    if (settings.solution_released) shorten(*settings.solution_released);
    const Extension* extension = extension_of(student, lab, course);
    const std::optional<Time> due = extension != nullptr ? extension->due : settings.due;
    if (!due) continue;
    shorten(*due);
    shorten(*due + floor<seconds>(duration<double, std::ratio<60>>(course.late->grace_minutes)));
    if (time > *due) shorten(*due + ceil<days>(time - *due));
  }
  return end;
}

}  // namespace cs550::gradebook
