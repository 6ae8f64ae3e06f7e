#include "gradebook/reports/write_reports.hpp"

#include "files/output_file.hpp"
#include "gradebook/reports/class_page.hpp"
#include "gradebook/reports/classroom.hpp"
#include "gradebook/reports/feedback.hpp"
#include "gradebook/reports/grades_csv.hpp"
#include "gradebook/reports/gradescope.hpp"
#include "gradebook/reports/junit.hpp"

namespace cs550::gradebook {
namespace {

std::vector<int> labs_in(const Record& record) {
  std::vector<int> labs;
  for (const LabRecord& lab : record.labs) labs.push_back(lab.lab);
  return labs;
}

/// The mark of one of a student's records by itself, with a note on labs for which another one counts.
StudentMark mark_of(const StudentMark& whole, const Record& record, const Course& course) {
  Student alone = whole.student;
  alone.records = {&record};
  StudentMark mark = mark_student(alone, labs_in(record), course);
  // Which milestones were reached in time depends on the student's other submissions.
  if (whole.engine.record == &record) mark.engine = whole.engine;
  for (LabMark& lab : mark.labs) {
    const LabMark* counted = whole.lab(lab.lab);
    if (counted->record == &record) {
      lab = *counted;  // it has no mark if the grader failed on another one
    } else if (counted->record != nullptr) {
      lab.notes.push_back("not what counts: that is " + counted->record->source);
    }
  }
  return mark;
}

void write_for_record(const std::filesystem::path& folder, const StudentMark& whole,
                      const Record& record, const Course& course) {
  const StudentMark mark = mark_of(whole, record, course);
  files::write_file(folder / "gradescope" / (record.name + ".json"), gradescope_json(mark, course));
  files::write_file(folder / "junit" / (record.name + ".xml"), junit_xml(record));
  files::write_file(folder / "classroom" / (record.name + ".json"), classroom_json(record));
  files::write_file(folder / "feedback" / (record.name + ".md"), feedback_markdown(mark, course));
  files::write_file(folder / "feedback" / (record.name + ".html"), feedback_html(mark, course));
}

}  // namespace

void write_reports(const std::filesystem::path& folder, const std::vector<Record>& records,
                   const std::vector<Student>& roster, const Course& course) {
  const std::vector<int> labs = labs_of(records);
  const std::vector<StudentMark> marks = mark_class(assign(roster, records), labs, course);
  for (const StudentMark& mark : marks) {
    for (const Record* record : mark.student.records) {
      write_for_record(folder, mark, *record, course);
    }
  }
  files::write_file(folder / "grades.csv", grades_csv(marks, labs));
  files::write_file(folder / "class.html", class_page(marks, labs, course));
}

}  // namespace cs550::gradebook
