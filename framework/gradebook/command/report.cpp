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

bool is_of_same_submission(const Record& record, const Record& earlier) {
  const bool has_its_path = !earlier.path.empty() && record.path == earlier.path;
  return record.name == earlier.name && (has_its_path || same_submission(record, earlier));
}

/// What records lack of an earlier one: the submission, a lab or the milestones. Empty if they lack nothing.
std::string missing_of(const Record& earlier, const std::vector<Record>& records) {
  const auto own = std::find_if(records.begin(), records.end(), [&earlier](const Record& record) {
    return is_of_same_submission(record, earlier);
  });
  if (own == records.end()) {
    return "the submission " + (earlier.path.empty() ? earlier.name : earlier.path);
  }
  for (const LabRecord& lab : earlier.labs) {
    if (own->lab(lab.lab) == nullptr) return fmt::format("lab {} of {}", lab.lab, earlier.name);
  }
  return earlier.engine && !own->engine ? "the milestones of " + earlier.name : "";
}

/// Refuses a folder with records of an earlier report that this one does not replace: a later one from this folder
/// would count them. Nor may it replace one that has more.
void check_has_no_other_records(const fs::path& out, const std::vector<Record>& records) {
  for (const Record& earlier : RecordFolder(out).records()) {
    const std::string missing = missing_of(earlier, records);
    if (missing.empty()) continue;
    throw std::invalid_argument(
        fmt::format("{} has records of an earlier report.\n  This one lacks {}.\n"
                    "  Choose another --out, or merge both: --report OLD NEW --out MERGED.",
                    out.string(), missing));
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
