#include "gradebook/marks/mark.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "gradebook/course/catalogue.hpp"
#include "gradebook/marks/dates.hpp"
#include "gradebook/marks/time_text.hpp"

namespace cs550::gradebook {
namespace {

std::optional<Time> due_date(const Student& student, int lab, const Course& course,
                             std::vector<std::string>& notes) {
  const Extension* extension = extension_of(student, lab, course);
  if (extension == nullptr) return course.lab(lab).due;
  notes.push_back("extension until " + to_text(extension->due, extension->offset));
  return extension->due;
}

void apply_regrades(LabMark& mark, const Student& student, const LabRecord& lab,
                    const Course& course) {
  std::set<std::string> granted;
  for (const RegradeRequest& request : course.regrades) {
    if (!is_about(request.student, student) || request.lab != mark.lab) continue;
    const auto test = std::find_if(lab.tests.begin(), lab.tests.end(),
                                   [&](const TestResult& t) { return t.name == request.test; });
    if (test == lab.tests.end()) continue;
    switch (request.status) {
      case RegradeRequest::Status::Open:
        mark.notes.push_back("regrade of " + request.test + " requested");
        break;
      case RegradeRequest::Status::Granted:
        if (!granted.insert(request.test).second) break;
        if (test->earned == test->points) {
          mark.notes.push_back("regrade of " + request.test + " has no effect: the test passed");
          break;
        }
        mark.earned += test->points - test->earned;
        mark.notes.push_back("regrade of " + request.test + " granted");
        break;
      case RegradeRequest::Status::Declined:
        mark.notes.push_back("regrade of " + request.test + " declined");
        break;
    }
  }
}

/// Whether a record's lab earns nothing, because its solution was released before.
bool is_after_release(const Student& student, const Record& record, int lab, const Course& course) {
  if (!course.late) return false;
  const std::optional<Time> released = course.lab(lab).solution_released;
  const std::optional<Time> time = time_of_submission(student, record, course);
  return released && time && *time > *released;
}

void apply_late_policy(LabMark& mark, const Student& student, const Course& course) {
  const std::optional<Time> due = due_date(student, mark.lab, course, mark.notes);
  if (!course.late) return;
  const std::optional<Time> time = time_of_submission(student, *mark.record, course);
  if (!time) {
    if (due) mark.notes.emplace_back("time of submission unknown: not counted as late");
    return;
  }
  if (is_after_release(student, *mark.record, mark.lab, course)) {
    mark.deduction = mark.mark;
    mark.mark = 0;
    mark.notes.emplace_back("submitted after the solution was released");
    return;
  }
  if (!due) return;
  const std::chrono::duration<double> late = *time - *due;
  if (late.count() <= 60 * course.late->grace_minutes) return;
  constexpr double seconds_per_day = 86400;
  mark.late_days = std::ceil(late.count() / seconds_per_day);
  const double percent =
      std::min(mark.late_days * course.late->percent_per_day, course.late->most_percent);
  mark.deduction = mark.mark * percent / 100;
  mark.mark -= mark.deduction;
  mark.notes.push_back(fmt::format("{} day{} late: {}% deducted", mark.late_days,
                                   mark.late_days == 1 ? "" : "s", points_text(percent)));
}

void apply_adjustments(LabMark& mark, const Student& student, const Course& course) {
  for (const Adjustment& adjustment : course.adjustments) {
    if (!is_about(adjustment.student, student) || adjustment.lab != mark.lab) continue;
    mark.adjustment += adjustment.points;
    mark.notes.push_back(fmt::format("{}{} points: {}", adjustment.points < 0 ? "" : "+",
                                     points_text(adjustment.points), adjustment.reason));
  }
  mark.mark = std::max(0.0, mark.mark + mark.adjustment);
}

/// The bonus for tests that the student has written.
void apply_own_tests(LabMark& mark, const LabRecord& lab, const Course& course) {
  if (!lab.own_tests) return;
  const OwnTests& own = *lab.own_tests;
  if (!own.not_graded.empty()) {
    mark.notes.emplace_back("my_tests.cpp NOT GRADED: the grader failed");
    return;
  }
  if (!own.compiled) {
    mark.notes.push_back(fmt::format(
        "my_tests.cpp {}: {}", own.stopped ? "was not compiled" : "does not compile", own.message));
    return;
  }
  if (own.fails_reference) {
    mark.notes.push_back("my_tests.cpp earns nothing: " + own.message);
    return;
  }
  mark.bonus = course.lab(mark.lab).own_tests * own.caught / std::max(1, own.mistakes);
  mark.mark += mark.bonus;
  mark.notes.push_back(fmt::format("my_tests.cpp finds {} of {} known mistakes: +{} points",
                                   own.caught, own.mistakes, points_text(mark.bonus)));
}

/// The points of the tests on the scale of the course.
double scaled(const LabMark& mark) {
  return mark.of == 0 ? 0 : mark.earned * mark.points / mark.of;
}

/// The mark that one of the student's records earns.
LabMark mark_record(const Student& student, const Record& record, const LabRecord& lab,
                    const Course& course) {
  LabMark mark;
  mark.lab = lab.lab;
  mark.record = &record;
  mark.earned = lab.earned();
  mark.of = lab.points();
  mark.points = course.lab(lab.lab).points;
  mark.is_graded = lab.not_graded.empty();
  if (!mark.is_graded) mark.notes.emplace_back("NOT GRADED: the grader failed");
  apply_regrades(mark, student, lab, course);
  mark.mark = scaled(mark);
  if (const std::string note = note_on_scale(mark); !note.empty()) mark.notes.push_back(note);
  apply_own_tests(mark, lab, course);
  apply_late_policy(mark, student, course);
  return mark;
}

/// The marks of all submissions of a lab.
std::vector<LabMark> attempts_at(const Student& student, int lab, const Course& course) {
  std::vector<LabMark> attempts;
  for (const Record* record : student.records) {
    const LabRecord* of_lab = record->lab(lab);
    if (of_lab == nullptr || !of_lab->submitted) continue;
    attempts.push_back(mark_record(student, *record, *of_lab, course));
  }
  return attempts;
}

/// Leaves those that may be the last: of the latest time, or of an unknown one.
void keep_last(std::vector<LabMark>& attempts, const Student& student, const Course& course) {
  const auto time = [&](const LabMark& mark) {
    return time_of_submission(student, *mark.record, course);
  };
  std::optional<Time> latest;  // an empty one is before every time
  for (const LabMark& mark : attempts) latest = std::max(latest, time(mark));
  std::erase_if(attempts, [&](const LabMark& mark) { return time(mark) && time(mark) < latest; });
  if (attempts.size() < 2) return;
  for (LabMark& mark : attempts) {
    mark.notes.emplace_back("which attempt is the last is unknown: the best of them counts");
  }
}

/// A lab without a submission.
LabMark no_mark(const Student& student, int lab, const Course& course) {
  LabMark mark;
  mark.lab = lab;
  mark.points = course.lab(lab).points;
  mark.was_run = student.records.empty() ||
                 std::any_of(student.records.begin(), student.records.end(),
                             [lab](const Record* record) { return record->lab(lab) != nullptr; });
  mark.notes.emplace_back(mark.was_run ? note_not_submitted : note_not_run);
  return mark;
}

/// Whether an attempt that the grader failed on might have been better.
bool might_be_better(const LabMark& failed, const LabMark& best, const Course& course) {
  if (best.earned < best.of || best.deduction > 0) return true;
  const std::vector<std::string>& files = failed.lab_record()->files;
  const bool has_own_tests = std::count(files.begin(), files.end(), own_tests_file) > 0;
  return has_own_tests && best.bonus < course.lab(best.lab).own_tests;
}

/// The mark that counts. If the grader failed on another attempt that might be better, there is none.
LabMark best_mark(const Student& student, int lab, const Course& course) {
  std::vector<LabMark> attempts = attempts_at(student, lab, course);
  if (attempts.empty()) return no_mark(student, lab, course);
  if (course.attempt == Attempt::Last) keep_last(attempts, student, course);
  const auto is_worse = [](const LabMark& a, const LabMark& b) { return a.mark < b.mark; };
  LabMark best = *std::max_element(attempts.begin(), attempts.end(), is_worse);
  if (!best.is_graded) return best;
  for (const LabMark& mark : attempts) {
    if (mark.is_graded || !might_be_better(mark, best, course)) continue;
    best.is_graded = false;
    best.notes.push_back("NOT GRADED: the grader failed on " + mark.record->source);
  }
  return best;
}

bool is_reached(const TestResult& milestone) { return milestone.status == "passed"; }

/// The lab whose code a milestone adds to the engine: 3 for one of step "L3".
int lab_of(const TestResult& milestone) { return std::atoi(milestone.step.c_str() + 1); }

/// The milestones that a student has reached before the solution of their lab was released. A later engine
/// may contain that solution, so only an earlier one shows that the student has reached them.
std::set<std::string> reached_in_time(const Student& student, const Course& course) {
  std::set<std::string> names;
  for (const Record* record : student.records) {
    if (!record->engine) continue;
    for (const TestResult& milestone : record->engine->tests) {
      if (is_reached(milestone) && !is_after_release(student, *record, lab_of(milestone), course))
        names.insert(milestone.name);
    }
  }
  return names;
}

/// Whether the grader failed to run its milestones.
bool has_broken_engine(const Record* record) {
  return record->engine && !record->engine->not_graded.empty();
}

/// The milestones of the labs that were graded: those of a student whose run left labs out are fewer.
int count_milestones(const std::vector<Student>& students) {
  std::size_t most = 0;
  for (const Student& student : students) {
    for (const Record* record : student.records) {
      if (record->engine) most = std::max(most, record->engine->tests.size());
    }
  }
  return static_cast<int>(most);
}

/// If the grader failed on another engine, that one might have reached more.
EngineMark best_engine(const Student& student, int milestones, const Course& course) {
  const std::set<std::string> in_time = reached_in_time(student, course);
  EngineMark best;
  for (const Record* record : student.records) {
    if (!record->engine) continue;
    EngineMark mark;
    mark.record = record;
    mark.of = milestones;
    for (const TestResult& milestone : record->engine->tests) {
      if (!is_reached(milestone)) continue;
      ++(in_time.contains(milestone.name) ? mark.reached : mark.too_late);
    }
    if (best.record == nullptr || mark.reached > best.reached) best = mark;
  }
  best.has_weight = course.milestones_weight > 0;
  best.is_graded = best.reached == best.of ||
                   std::none_of(student.records.begin(), student.records.end(), has_broken_engine);
  return best;
}

/// The weighted total of the labs and the milestones, in percent.
double total_percent(const StudentMark& mark, const Course& course) {
  double sum = 0;
  double weights = 0;
  for (const LabMark& lab : mark.labs) {
    const double weight = course.lab(lab.lab).weight;
    sum += weight * lab.mark / lab.points;
    weights += weight;
  }
  const EngineMark& engine = mark.engine;
  if (engine.of > 0) sum += course.milestones_weight * engine.reached / engine.of;
  if (engine.of > 0 || !engine.was_run) weights += course.milestones_weight;
  return weights > 0 ? 100 * sum / weights : 0;
}

StudentMark mark_one(const Student& student, const std::vector<int>& labs, int milestones,
                     const Course& course) {
  StudentMark result{student, {}, 0, best_engine(student, milestones, course)};
  for (const int lab : labs) {
    LabMark mark = best_mark(student, lab, course);
    apply_adjustments(mark, student, course);
    result.labs.push_back(std::move(mark));
  }
  result.percent = total_percent(result, course);
  return result;
}

/// Milestones that no run has run for a student, but for others, count as a lab that no run graded: as 0.
void count_missing_milestones(std::vector<StudentMark>& marks, const Course& course) {
  const bool counts = course.milestones_weight > 0 && have_engines(marks);
  for (StudentMark& mark : marks) {
    const bool has_nothing = mark.is_missing() && mark.percent == 0;  // no points by hand either
    if (!counts || mark.engine.record != nullptr || has_nothing) continue;
    mark.engine.was_run = false;
    mark.percent = total_percent(mark, course);
  }
}

}  // namespace

bool StudentMark::is_graded() const {
  return (engine.is_graded || !engine.has_weight) &&
         std::all_of(labs.begin(), labs.end(), [](const LabMark& mark) { return mark.is_graded; });
}

bool StudentMark::has_no_lab() const {
  const auto is_readable = [](const Record* record) { return record->trouble.empty(); };
  const auto has_no_record = [](const LabMark& mark) { return mark.record == nullptr; };
  return !is_missing() && std::all_of(labs.begin(), labs.end(), has_no_record) &&
         std::all_of(student.records.begin(), student.records.end(), is_readable);
}

bool StudentMark::has_scattered_labs() const {
  const auto has_all = [this](const Record* record) {
    return std::all_of(labs.begin(), labs.end(), [record](const LabMark& mark) {
      const LabRecord* lab = record->lab(mark.lab);
      return mark.record == nullptr || (lab != nullptr && lab->submitted);
    });
  };
  return engine.record != nullptr &&
         std::none_of(student.records.begin(), student.records.end(), has_all);
}

const LabMark* StudentMark::lab(int number) const {
  for (const LabMark& mark : labs) {
    if (mark.lab == number) return &mark;
  }
  return nullptr;
}

std::vector<int> labs_of(const std::vector<Record>& records) {
  std::set<int> labs;
  for (const Record& record : records) {
    for (const LabRecord& lab : record.labs) labs.insert(lab.lab);
  }
  return {labs.begin(), labs.end()};
}

StudentMark mark_student(const Student& student, const std::vector<int>& labs,
                         const Course& course) {
  return mark_one(student, labs, count_milestones({student}), course);
}

std::vector<StudentMark> mark_class(const std::vector<Student>& students,
                                    const std::vector<int>& labs, const Course& course) {
  std::vector<StudentMark> marks;
  marks.reserve(students.size());
  const int milestones = count_milestones(students);
  for (const Student& student : students) {
    marks.push_back(mark_one(student, labs, milestones, course));
  }
  count_missing_milestones(marks, course);
  return marks;
}

bool have_engines(const std::vector<StudentMark>& marks) {
  return std::any_of(marks.begin(), marks.end(),
                     [](const StudentMark& mark) { return mark.engine.record != nullptr; });
}

std::vector<std::string> entries_about_nobody(const Course& course,
                                              const std::vector<Student>& students) {
  std::vector<std::string> lines;
  const auto check = [&](const char* table, const auto& entries) {
    for (const auto& entry : entries) {
      const bool is_known = std::any_of(
          students.begin(), students.end(),
          [&entry](const Student& student) { return is_about(entry.student, student); });
      if (!is_known)
        lines.push_back(fmt::format("[[{}]] of lab {} for {}", table, entry.lab, entry.student));
    }
  };
  check("extension", course.extensions);
  check("adjustment", course.adjustments);
  check("regrade", course.regrades);
  return lines;
}

std::string note_on_scale(const LabMark& mark) {
  if (mark.points == mark.of) return {};
  return fmt::format("the tests give {} of {} points, which count as {} of {}", mark.earned,
                     mark.of, points_text(scaled(mark)), points_text(mark.points));
}

std::string points_text(double points) {
  // Adding zero turns -0 into 0.
  std::string text = fmt::format("{:.2f}", std::round(points * 100) / 100 + 0.0);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace cs550::gradebook
