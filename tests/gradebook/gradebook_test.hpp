#pragma once
/// @file gradebook_test.hpp
/// Small records and catalogues for the tests of the gradebook.

#include <filesystem>
#include <string>
#include <vector>

#include "gradebook/course/catalogue.hpp"
#include "gradebook/course/course_file.hpp"
#include "gradebook/intake/discovery.hpp"
#include "gradebook/records/record.hpp"
#include "helpers/scratch_folder.hpp"

namespace cs550::gradebook {

inline const Catalogue& project_catalogue() {
  static const Catalogue catalogue = read_catalogue(CS550_ROOT);
  return catalogue;
}

inline Course course_of(const std::string& text) {
  return parse_course(text, "course.toml", project_catalogue());
}

/// Lab 3 with two visible tests of 24 points and a hidden one of 12.
inline LabRecord lab_record(int first, int second, int hidden) {
  LabRecord lab;
  lab.lab = 3;
  lab.submitted = lab.compiled = true;
  const auto add = [&lab](const char* name, int points, int earned, bool is_hidden) {
    lab.tests.push_back({name, "L3.1", points, earned, earned == points ? "passed" : "failed",
                         is_hidden, 0.5, earned == points ? "" : "expected 1 m, got 2 m", ""});
  };
  add("Lab3.FirstOfEqualVerticesWins", 24, first, false);
  add("Lab3.ClimbEndsOnAPlateau", 24, second, false);
  add("Lab3.Secret", 12, hidden, true);
  return lab;
}

inline Record record_of(const std::string& student, const LabRecord& lab) {
  Record record;
  record.name = record.source = record.student = student;
  record.hash = student;
  record.project = "0123456789ab";
  record.labs = {lab};
  return record;
}

/// With a milestone for each of labs 1, 2, ...
inline Record with_engine(Record record, const std::vector<std::string>& statuses) {
  record.engine = LabRecord{};
  record.engine->submitted = record.engine->compiled = true;
  for (const std::string& status : statuses) {
    const std::string lab = std::to_string(record.engine->tests.size() + 1);
    record.engine->tests.push_back({"Milestone." + lab, "L" + lab, 0, 0, status, false, 0, "", ""});
  }
  return record;
}

/// Whose milestones the grader failed to run.
inline Record with_broken_engine(const Record& record, std::size_t milestones) {
  Record broken = with_engine(record, std::vector<std::string>(milestones, "not_submitted"));
  broken.engine->not_graded = "the judge broke";
  return broken;
}

using test::ScratchFolder;

/// A submission that tries to write into every report.
inline Record hostile_record() {
  Record record = record_of("=<script>alert(1)</script>", lab_record(0, 24, 0));
  record.labs[0].tests[0].message = "\033[31m<script>alert(1)</script> ]]> ``` **bold** \xFF";
  record.labs[0].tests[2].message = "the secret: use the twin edge";
  record.labs[0].compile_errors = "</pre><script>alert(1)</script>";
  record.ignored = {{"<img src=x onerror=alert(1)>", "not C++", 1}};
  record.name = "hostile";
  return record;
}

/// The only submission at a path.
inline Submission read(const std::filesystem::path& source) {
  return read_submission(find_submissions({source}, project_catalogue()).submissions.at(0),
                         project_catalogue());
}

}  // namespace cs550::gradebook
