#include "gradebook/marks/pseudonyms.hpp"

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

void remove_texts(LabRecord& lab) {
  lab.files.clear();
  lab.same_as.clear();
  lab.compile_errors.clear();
  if (lab.own_tests) {
    lab.own_tests->message.clear();
    if (!lab.own_tests->not_graded.empty()) lab.own_tests->not_graded = "the grader failed";
  }
  for (TestResult& test : lab.tests) test.message.clear();
}

Record without_names(Record record, const std::string& student, std::size_t number) {
  record.name = number == 0 ? student : student + '-' + std::to_string(number + 1);
  record.source = record.name;
  record.path.clear();
  record.student = student;
  record.claimed_student.clear();
  record.ignored.clear();
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
    }
    if (!roster.empty() && student.on_roster) {
      result.roster.push_back({name, "", "", student.section, student.submitted, true, {}});
    }
  }
  const auto rename = [&](auto& entries) {
    for (auto& entry : entries) {
      entry.student = pseudonym(id_in(students, entry.student), course.secret);
    }
  };
  rename(result.course.adjustments);
  rename(result.course.extensions);
  rename(result.course.regrades);
  return result;
}

}  // namespace cs550::gradebook
