#include "gradebook/command/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>

#include "cli/system/files.hpp"
#include "cli/system/terminal.hpp"
#include "files/output_file.hpp"
#include "gradebook/course/course_file.hpp"
#include "gradebook/marks/dates.hpp"
#include "gradebook/marks/mark.hpp"

namespace cs550::gradebook {
namespace {

namespace fs = std::filesystem;

constexpr const char* course_copy = "course.toml";
constexpr const char* roster_copy = "roster.csv";

/// The file that was named, else the folder's copy, if there is one.
fs::path chosen(const fs::path& named, const fs::path& folder, const char* copy) {
  if (!named.empty()) return named;
  return !folder.empty() && fs::exists(folder / copy) ? folder / copy : fs::path();
}

void keep(const std::string& text, const fs::path& file) {
  if (text.empty()) return;
  files::write_file(file, text);
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
}

void print_unknown(const Student& student, const std::vector<Student>& roster) {
  for (const Record* record : student.records) {
    const std::vector<std::string> ids = rivals(roster, *record);
    const std::string why =
        ids.empty() ? ""
                    : fmt::format(": the name fits {}. Put the id into the name of the file",
                                  fmt::join(ids, " and "));
    const std::string& place = record->path.empty() ? record->source : record->path;
    std::cout << cli::indented(fmt::format("not on the roster: {}{}", place, why), 0);
  }
}

}  // namespace

Settings read_settings(const fs::path& root, const fs::path& course, const fs::path& roster,
                       const fs::path& folder) {
  Settings settings;
  settings.catalogue = read_catalogue(root);
  if (const fs::path file = chosen(course, folder, course_copy); !file.empty()) {
    settings.course_text = cli::read_text(file);
    settings.course = parse_course(settings.course_text, file.string(), settings.catalogue);
  }
  if (const fs::path file = chosen(roster, folder, roster_copy); !file.empty()) {
    settings.roster_text = cli::read_text(file);
    settings.roster = parse_roster(settings.roster_text, file.string());
  }
  check_extensions(settings.course, settings.roster);
  return settings;
}

void keep_settings(const Settings& settings, const fs::path& folder) {
  keep(settings.course_text, folder / course_copy);
  keep(settings.roster_text, folder / roster_copy);
}

void print_skipped(const Discovery& found) {
  for (const IgnoredFile& file : found.skipped) {
    std::cout << fmt::format("skipped: {}: {}\n", file.path, file.reason);
  }
}

void print_entries_about_nobody(const Settings& settings, const std::vector<Record>& records) {
  if (settings.roster.empty() && records.size() == 1) return;
  const std::vector<Student> students = assign(settings.roster, records);
  for (const std::string& entry : entries_about_nobody(settings.course, students)) {
    std::cout << fmt::format("no such student: {}; the entry has no effect\n", entry);
  }
}

void print_students_to_look_at(const Settings& settings, const std::vector<Record>& records) {
  const std::vector<Student> students = assign(settings.roster, records);
  for (const StudentMark& mark : mark_class(students, labs_of(records), settings.course)) {
    if (!mark.student.on_roster) print_unknown(mark.student, settings.roster);
    if (mark.has_no_lab()) std::cout << fmt::format("no graded lab: {}\n", mark.student.id);
    for (const LabMark& lab : mark.labs) {
      if (lab.was_run) continue;
      std::cout << cli::indented(
          fmt::format("{}, lab {}: {}", mark.student.id, lab.lab, note_not_run), 0);
    }
    if (!mark.engine.was_run) {
      std::cout << cli::indented(fmt::format("{}: {}", mark.student.id, note_no_milestones), 0);
    }
    if (!mark.has_scattered_labs()) continue;
    std::cout << cli::indented(
        fmt::format("{}: {}", mark.student.id, milestones_need_one_submission), 0);
  }
}

void print_expired(const RecordFolder& folder, const Course& course) {
  if (!course.retention_days) return;
  const std::vector<fs::path> expired = folder.older_than(*course.retention_days);
  if (expired.empty()) return;
  std::cout << fmt::format("Records older than {} days (retention_days), to be deleted:\n",
                           *course.retention_days);
  for (const fs::path& file : expired) std::cout << "  " << file.string() << '\n';
}

}  // namespace cs550::gradebook
