#include "gradebook/command/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "files/output_file.hpp"
#include "gradebook/command/settings.hpp"
#include "gradebook/marks/pseudonyms.hpp"
#include "gradebook/records/merge.hpp"
#include "gradebook/records/record_folder.hpp"
#include "gradebook/reports/write_reports.hpp"
#include "gradebook/text/escape.hpp"

namespace cs550::gradebook {
namespace {

namespace fs = std::filesystem;

std::vector<Record> merged_records(const std::vector<fs::path>& folders) {
  std::vector<std::vector<Record>> all;
  all.reserve(folders.size());
  for (const fs::path& folder : folders) all.push_back(records_in(folder));
  return merged(all);
}

void print_unfinished(const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    if (!RecordFolder(folder).is_unfinished()) continue;
    std::cout << fmt::format(
        "{}: this run was interrupted, or is still going on. Submissions that are not graded yet\n"
        "  are reported as missing. To continue it, add --resume to its command.\n",
        folder.string());
  }
}

/// The key is for the instructor alone: it stays with the records that have names.
void write_key(const PseudonymousClass& pseudonymous, const fs::path& folder) {
  const fs::path file = folder / "pseudonyms.csv";
  std::string text = "pseudonym,id\n";
  for (const auto& [name, id] : pseudonymous.key) text += name + ',' + csv(id) + '\n';
  files::write_file(file, text);
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  std::cout << "Who is who is in " << file.string() << '\n';
}

/// Records without a path have pseudonyms. Their times depend on the dates of the course.
bool is_of_same_submission(const Record& record, const Record& earlier) {
  if (record.path.empty() && earlier.path.empty()) {
    return record.student == earlier.student && record.hash == earlier.hash;
  }
  return record.path == earlier.path || same_submission(record, earlier);
}

/// Whether the grader has failed on nothing that it graded before.
bool is_graded_like(const LabRecord& earlier, const LabRecord& lab) {
  return (lab.not_graded.empty() || !earlier.not_graded.empty()) &&
         (lab.is_graded() || !earlier.is_graded());
}

bool has_milestones_of(const Record& earlier, const Record& record) {
  if (!earlier.engine) return true;
  const std::vector<TestResult>& milestones = earlier.engine->tests;
  return record.engine && is_graded_like(*earlier.engine, *record.engine) &&
         std::all_of(milestones.begin(), milestones.end(), [&record](const TestResult& milestone) {
           return record.engine->has_test(milestone.name);
         });
}

/// What a record lacks of an earlier one of the same submission. Empty if it lacks nothing.
std::string missing_of(const Record& earlier, const Record& record) {
  for (const LabRecord& lab : earlier.labs) {
    const LabRecord* own = record.lab(lab.lab);
    if (own == nullptr || !is_graded_like(lab, *own)) {
      return fmt::format("results for lab {} of {}", lab.lab, earlier.name);
    }
  }
  return has_milestones_of(earlier, record) ? "" : "milestones of " + earlier.name;
}

/// Why a report must not replace an earlier record, and what to do instead. Empty if it may.
std::string objection(const Record& earlier, const std::vector<Record>& records,
                      const fs::path& out) {
  const bool is_pseudonymous = earlier.path.empty();
  const std::string submission = is_pseudonymous ? earlier.name : earlier.path;
  std::string missing = "the submission " + submission;
  bool is_renamed = false;
  for (const Record& record : records) {
    if (!is_of_same_submission(record, earlier)) continue;
    is_renamed = record.name != earlier.name;
    if (is_renamed) continue;
    missing = missing_of(earlier, record);
    break;
  }
  if (missing.empty()) return {};
  if (is_pseudonymous) return fmt::format("This one lacks {}.\n  Choose another --out.", missing);
  if (is_renamed) {
    return fmt::format(
        "The record {} of {} would be replaced by that of another submission.\n"
        "  Name {} first, or choose another --out.",
        earlier.name, submission, out.string());
  }
  return fmt::format(
      "This one lacks {}.\n"
      "  Choose another --out, or merge both: --report OLD NEW --out MERGED.",
      missing);
}

/// Refuses a folder with records of an earlier report that this one does not replace: a later one from this folder
/// would count them. Nor may it replace one that has more.
void check_has_no_other_records(const fs::path& out, const std::vector<Record>& records) {
  for (const Record& earlier : RecordFolder(out).records()) {
    const std::string reason = objection(earlier, records, out);
    if (reason.empty()) continue;
    throw std::invalid_argument(
        fmt::format("{} has records of an earlier report.\n  {}", out.string(), reason));
  }
}

/// Refuses a folder in which an earlier report has left names. Records with a path have them.
void check_has_no_names(const fs::path& out) {
  const std::vector<Record> present = RecordFolder(out).records();
  const bool has_paths = std::any_of(present.begin(), present.end(),
                                     [](const Record& record) { return !record.path.empty(); });
  std::string names = has_paths ? "records" : "";
  for (const char* file : {"course.toml", "roster.csv"}) {
    if (fs::exists(out / file)) names = file;
  }
  if (names.empty()) return;
  throw std::invalid_argument(fmt::format(
      "{} has {} of an earlier report, with names.\n  Choose another --out.", out.string(), names));
}

}  // namespace

std::vector<Record> records_in(const fs::path& folder) {
  std::vector<Record> records = RecordFolder(folder).records();
  if (!records.empty()) return records;
  throw std::runtime_error(folder.string() + " has no records. Expected " +
                           (folder / "records").string() + "/NAME.json");
}

void report(const ReportRequest& request) {
  std::error_code is_new;
  const bool in_place =
      request.folders.size() == 1 && fs::equivalent(request.folders[0], request.out, is_new);
  if (request.pseudonyms && in_place) {
    throw std::invalid_argument("--pseudonyms needs --out, a folder beside the records with names");
  }
  Settings settings =
      read_settings(request.root, request.course, request.roster, request.folders.front());
  std::vector<Record> records = merged_records(request.folders);
  if (request.pseudonyms && settings.course.secret.empty()) {
    throw std::invalid_argument(
        "--pseudonyms needs a secret in the course file, or they could be guessed");
  }
  const FolderLock lock(request.out);
  if (request.pseudonyms) {
    PseudonymousClass pseudonymous = with_pseudonyms(records, settings.roster, settings.course);
    check_has_no_names(request.out);
    check_has_no_other_records(request.out, pseudonymous.records);
    write_key(pseudonymous, request.folders.front());
    records = std::move(pseudonymous.records);
    settings.roster = std::move(pseudonymous.roster);
    settings.course = std::move(pseudonymous.course);
  } else {
    if (!in_place) check_has_no_other_records(request.out, records);
    keep_settings(settings, request.out);
  }
  if (!in_place) {
    for (const Record& record : records) RecordFolder(request.out).store(record);
  }
  write_reports(request.out, records, settings.roster, settings.course);
  print_students_to_look_at(settings, records);
  print_entries_about_nobody(settings, records);
  print_unfinished(request.folders);
  std::cout << fmt::format("Reports on {} submissions are in {}\n", records.size(),
                           request.out.string());
  print_expired(RecordFolder(request.folders.front()), settings.course);
}

}  // namespace cs550::gradebook
