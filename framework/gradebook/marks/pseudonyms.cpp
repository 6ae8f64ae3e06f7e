#include "gradebook/marks/pseudonyms.hpp"

#include <algorithm>
#include <optional>

#include "gradebook/course/catalogue.hpp"
#include "gradebook/marks/dates.hpp"
#include "gradebook/marks/time_text.hpp"
#include "gradebook/text/sha256.hpp"

namespace cs550::gradebook {
namespace {

std::string pseudonym(const std::string& id, const std::string& secret) {
  constexpr std::size_t digits = 10;
  return "student-" + sha256_of({secret, "pseudonym", id}).substr(0, digits);
}

/// The id of the student whom an entry of the course file is about; the entry if there is none.
std::string id_in(const std::vector<Student>& students, const std::string& entry) {
  for (const Student& student : students) {
    if (is_about(entry, student)) return student.id;
  }
  return entry;
}

/// A text that is there stays there, without what it tells.
void replace_text(std::string& text, const char* other) {
  if (!text.empty()) text = other;
}

void remove_texts(LabRecord& lab) {
  // Whether tests of the student's own were handed in decides about marks.
  std::erase_if(lab.files, [](const std::string& file) { return file != own_tests_file; });
  lab.same_as.clear();
  lab.compile_errors.clear();
  replace_text(lab.not_graded, "the grader failed");
  if (lab.own_tests) {
    lab.own_tests->message.clear();
    replace_text(lab.own_tests->not_graded, "the grader failed");
  }
  for (TestResult& test : lab.tests) test.message.clear();
}

std::vector<int> submitted_labs(const std::vector<const Record*>& records) {
  std::vector<int> labs;
  for (const Record* record : records) {
    for (const LabRecord& lab : record->labs) {
      if (lab.submitted) labs.push_back(lab.lab);
    }
  }
  return labs;
}

/// Leaves so much of the time of a record as its marks and the order of the student's attempts need.
void hide_time(Record& record, const Record& original, const Student& student,
               const Course& course) {
  record.file_time.reset();
  record.claimed_date.clear();
  const std::optional<Time> time = time_of_submission(student, original, course);
  if (!time) return;
  const auto later = std::count_if(
      student.records.begin(), student.records.end(),
      [&](const Record* other) { return time_of_submission(student, *other, course) > time; });
  // With the dates of all labs of the student: those of its own labs alone could turn the order round.
  const Time shown = coarse_time(*time, submitted_labs(student.records), student, course) -
                     std::chrono::seconds(later);
  const Clock clock = course.late ? course.late->clock : Clock::File;
  if (clock == Clock::File) record.file_time = shown.time_since_epoch().count();
  if (clock == Clock::Manifest) record.claimed_date = to_text(shown);
}

Record without_names(Record record, const std::string& student, std::size_t number) {
  record.name = number == 0 ? student : student + '-' + std::to_string(number + 1);
  record.source = record.name;
  record.path.clear();
  record.folders.clear();
  record.student = student;
  record.claimed_student.clear();
  record.starter.clear();
  record.ignored.clear();
  replace_text(record.trouble, "unreadable");
  for (LabRecord& lab : record.labs) remove_texts(lab);
  if (record.engine) remove_texts(*record.engine);
  return record;
}

}  // namespace

PseudonymousClass with_pseudonyms(const std::vector<Record>& records,
                                  const std::vector<Student>& roster, const Course& course) {
  PseudonymousClass result;
  result.course = course;
  const std::vector<Student> students = assign(roster, records);
  for (const Student& student : students) {
    const std::string name = pseudonym(student.id, course.secret);
    result.key[name] = student.id;
    for (std::size_t i = 0; i < student.records.size(); ++i) {
      result.records.push_back(without_names(*student.records[i], name, i));
      hide_time(result.records.back(), *student.records[i], student, course);
    }
    if (!roster.empty() && student.on_roster) {
      std::optional<Time> submitted = student.submitted;
      if (submitted) {
        submitted = coarse_time(*submitted, submitted_labs(student.records), student, course);
      }
      result.roster.push_back({name, "", "", student.section, submitted, true, {}});
    }
  }
  // The order of the roster, or of names, would tell who is who.
  std::sort(result.roster.begin(), result.roster.end(),
            [](const Student& a, const Student& b) { return a.id < b.id; });
  std::sort(result.records.begin(), result.records.end(),
            [](const Record& a, const Record& b) { return a.name < b.name; });
  const auto rename = [&](auto& entries) {
    for (auto& entry : entries) {
      entry.student = pseudonym(id_in(students, entry.student), course.secret);
    }
  };
  for (Adjustment& adjustment : result.course.adjustments) adjustment.reason = "adjustment";
  rename(result.course.adjustments);
  rename(result.course.extensions);
  rename(result.course.regrades);
  return result;
}

}  // namespace cs550::gradebook
