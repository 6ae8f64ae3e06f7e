#pragma once
/// @file record_folder.hpp
/// The output folder of the grader: records, results of labs that were graded, one grader at a
/// time.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gradebook/records/record.hpp"

namespace cs550::gradebook {

/// While this object lives, no other grader works on the folder. Where the file system has no locks, a warning
/// is printed instead.
class FolderLock {
 public:
  /// Creates the folder, which only its owner can enter. Throws std::runtime_error if another grader works on it.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_ = -1;
};

/// Files are written beside their names and then renamed, so a reader never sees half a record.
class RecordFolder {
 public:
  explicit RecordFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  const std::filesystem::path& path() const { return folder_; }

  /// All records, sorted by name. Throws std::runtime_error if one is damaged.
  std::vector<Record> records() const;
  bool has_records() const;
  void store(const Record& record) const;
  /// The files of records that were written more than so many days ago.
  std::vector<std::filesystem::path> older_than(int days) const;

  /// A run is unfinished from its beginning until its end, also if it is interrupted.
  /// @{
  void begin_run() const;
  void end_run() const;
  bool is_unfinished() const;
  /// @}

  /// The result of a lab's files, by a key that names everything it depends on.
  std::optional<LabRecord> result(const std::string& key) const;
  void store_result(const std::string& key, const LabRecord& lab) const;

 private:
  std::filesystem::path file_of(const std::string& name) const;
  std::filesystem::path result_file(const std::string& key) const;

  std::filesystem::path folder_;
};

}  // namespace cs550::gradebook
