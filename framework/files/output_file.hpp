#pragma once
/// @file output_file.hpp
/// Files that are written as a whole or not at all.

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

namespace cs550::files {

/// A file that appears when it is complete. Until then its bytes are in a draft without a name,
/// which vanishes with the process, however that ends. Where the file system has no nameless files,
/// the draft has a name, and stays behind if the process is killed.
///
/// What exists and is no ordinary file (a device, a pipe) is not replaced: the bytes are written to it. A symbolic
/// link stays, and the file behind it is replaced. The new file has the permissions of the one that it replaces.
///
/// Every function throws std::runtime_error that names the file and the system's reason.
class OutputFile {
 public:
  /// Creates the folder of the file if it is absent.
  explicit OutputFile(const std::filesystem::path& file);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);

  /// Checks that every byte was written, then gives the draft the file's name.
  void commit();

 private:
  struct Close {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };

  [[noreturn]] void fail() const;
  int open_draft();
  void keep_permissions() const;
  void name_draft() const;

  std::filesystem::path file_;
  std::filesystem::path draft_;  ///< empty if the bytes are written to what exists
  bool draft_has_name_ = false;
  std::unique_ptr<std::FILE, Close> stream_;
};

/// Writes a whole file.
void write_file(const std::filesystem::path& file, std::string_view bytes);

/// Replaces `to` by a copy of `from`.
void copy_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Whether a path is a link of the system's own to what is already open, such as /dev/stdout.
bool is_link_of_the_system(const std::filesystem::path& path);

/// Flushes standard output. @throws std::runtime_error if some of it could not be written, for
/// example to a full disk
void check_standard_output();

}  // namespace cs550::files
