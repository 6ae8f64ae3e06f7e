#include "gradebook/records/record_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <iostream>
#include <stdexcept>

#include "cli/system/files.hpp"
#include "cli/system/terminal.hpp"
#include "files/output_file.hpp"
#include "gradebook/records/record_json.hpp"

namespace cs550::gradebook {

namespace fs = std::filesystem;

namespace {

/// The name of a file that is there during a run.
constexpr const char* unfinished = "unfinished";

}  // namespace

FolderLock::FolderLock(const fs::path& folder) {
  std::error_code error;
  // Records are for the instructor alone. A folder that exists keeps its permissions.
  if (fs::create_directories(folder, error)) {
    fs::permissions(folder, fs::perms::owner_all, error);
  }
  const fs::path file = folder / ".lock";
  file_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (file_ < 0) throw std::runtime_error("cannot write to " + folder.string());
  if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
  if (errno == EWOULDBLOCK) {
    close(file_);
    throw std::runtime_error("another grader is at work in " + folder.string() +
                             ". Wait until it has finished, or choose another --out");
  }
  // Not every file system of a network has locks.
  std::cerr << cli::indented(
      "Cannot lock " + folder.string() +
          ": do not run another ./cs550 grade in it until this one has ended.",
      0);
}

FolderLock::~FolderLock() { close(file_); }

std::vector<Record> RecordFolder::records() const {
  std::vector<Record> records;
  for (const fs::path& file : cli::files_below(folder_ / "records")) {
    if (file.extension() != ".json") continue;
    records.push_back(record_from_json(cli::read_text(file), file.string()));
  }
  return records;
}

bool RecordFolder::has_records() const { return !cli::files_below(folder_ / "records").empty(); }

void RecordFolder::store(const Record& record) const {
  files::write_file(file_of(record.name), to_json(record));
}

std::vector<fs::path> RecordFolder::older_than(int days) const {
  const auto limit = fs::file_time_type::clock::now() - std::chrono::hours(24) * days;
  std::vector<fs::path> files = cli::files_below(folder_ / "records");
  std::erase_if(files, [&](const fs::path& file) { return fs::last_write_time(file) >= limit; });
  return files;
}

void RecordFolder::begin_run() const {
  files::write_file(folder_ / unfinished, "This run of ./cs550 grade has not finished.\n");
}

void RecordFolder::end_run() const { fs::remove(folder_ / unfinished); }

bool RecordFolder::is_unfinished() const { return fs::exists(folder_ / unfinished); }

std::optional<LabRecord> RecordFolder::result(const std::string& key) const {
  const fs::path file = result_file(key);
  if (!fs::exists(file)) return std::nullopt;
  return lab_from_json(cli::read_text(file), file.string());
}

void RecordFolder::store_result(const std::string& key, const LabRecord& lab) const {
  files::write_file(result_file(key), to_json(lab));
}

fs::path RecordFolder::file_of(const std::string& name) const {
  return folder_ / "records" / (name + ".json");
}

fs::path RecordFolder::result_file(const std::string& key) const {
  return folder_ / "results" / (key + ".json");
}

}  // namespace cs550::gradebook
