#include "files/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>

namespace cs550::files {

namespace fs = std::filesystem;

namespace {

constexpr mode_t all_permissions = 0777;
constexpr mode_t readable_and_writable = 0666;  // the umask removes what the user does not want

/// Whether renaming onto the path destroys nothing but an ordinary file.
bool is_replaceable(const fs::path& file) {
  std::error_code unknown;
  const fs::file_status status = fs::symlink_status(file, unknown);
  return !fs::exists(status) || fs::is_regular_file(status);
}

bool is_below(const fs::path& file, const char* folder) {
  return fs::absolute(file).lexically_normal().string().starts_with(folder);
}

/// The ordinary file behind symbolic links, which keeps its content until the new one is complete and need not
/// exist; otherwise the path itself.
fs::path target_of(const fs::path& file) {
  constexpr int most_links = 40;  // as many as the system follows
  std::error_code error;
  fs::path target = file;
  for (int links = 0; fs::is_symlink(target, error); ++links) {
    if (links == most_links || is_link_of_the_system(target)) return file;
    target = target.parent_path() / fs::read_symlink(target, error);
  }
  return is_below(target, "/proc/") || !is_replaceable(target) ? file : target;
}

/// Calls a function that creates a draft. A draft that is already there is left from a process of the same
/// number, before a restart or in another container: it is removed.
template <class Create>
int create_draft(const fs::path& draft, const Create& create) {
  const int result = create();
  if (result >= 0 || errno != EEXIST || unlink(draft.c_str()) != 0) return result;
  return create();
}

int open_nameless([[maybe_unused]] const fs::path& folder) {
#ifdef O_TMPFILE
  return open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, readable_and_writable);
#else
  return -1;
#endif
}

}  // namespace

bool is_link_of_the_system(const fs::path& path) {
  std::error_code unknown;
  // Anybody may write to /dev/shm.
  const bool is_in_dev = is_below(path, "/dev/") && !is_below(path, "/dev/shm/");
  return (is_in_dev || is_below(path, "/proc/")) && fs::is_symlink(path, unknown);
}

OutputFile::OutputFile(const fs::path& file) : file_(target_of(file)) {
  const fs::path folder = fs::absolute(file_).parent_path();
  std::error_code error;
  fs::create_directories(folder, error);
  if (is_replaceable(file_)) {
    // Not the whole name: with the ending it could be too long for the file system.
    const std::string beginning = file_.filename().string().substr(0, 200);
    draft_ = folder / (beginning + ".draft" + std::to_string(getpid()));
  }
  const int descriptor =
      draft_.empty()
          ? open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, readable_and_writable)
          : open_draft();
  if (descriptor < 0) fail();
  stream_.reset(fdopen(descriptor, "wb"));
  if (!stream_) fail();
}

OutputFile::~OutputFile() {
  if (!draft_has_name_) return;
  std::error_code ignored;
  fs::remove(draft_, ignored);
}

int OutputFile::open_draft() {
  const int nameless = open_nameless(draft_.parent_path());
  if (nameless >= 0) return nameless;
  const int named = create_draft(draft_, [this] {
    return open(draft_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, readable_and_writable);
  });
  draft_has_name_ = named >= 0;
  return named;
}

void OutputFile::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), stream_.get()) != bytes.size()) fail();
}

void OutputFile::commit() {
  if (std::fflush(stream_.get()) != 0) fail();
  if (!draft_.empty()) {
    keep_permissions();
    name_draft();
    draft_has_name_ = true;
  }
  if (std::fclose(stream_.release()) != 0) fail();
  if (draft_.empty()) return;
  if (std::rename(draft_.c_str(), file_.c_str()) != 0) fail();
  draft_has_name_ = false;
}

/// Gives the draft the permissions of the file that it replaces, if there is one.
void OutputFile::keep_permissions() const {
  struct stat before {};
  if (stat(file_.c_str(), &before) != 0) return;
  if (fchmod(fileno(stream_.get()), before.st_mode & all_permissions) != 0) fail();
}

/// Gives a nameless draft its name. A link cannot replace a file; the rename that follows can.
void OutputFile::name_draft() const {
  if (draft_has_name_) return;
  const std::string descriptor = "/proc/self/fd/" + std::to_string(fileno(stream_.get()));
  const int linked = create_draft(draft_, [&] {
    return linkat(AT_FDCWD, descriptor.c_str(), AT_FDCWD, draft_.c_str(), AT_SYMLINK_FOLLOW);
  });
  if (linked != 0) fail();
}

void OutputFile::fail() const {
  const char* const reason = std::strerror(errno);
  throw std::runtime_error("cannot write " + file_.string() + ": " + reason);
}

void write_file(const fs::path& file, std::string_view bytes) {
  OutputFile output(file);
  output.write(bytes);
  output.commit();
}

void copy_file(const fs::path& from, const fs::path& to) {
  std::ifstream source(from, std::ios::binary);
  OutputFile copy(to);
  for (std::array<char, 1 << 16> bytes;
       source.read(bytes.data(), bytes.size()), source.gcount() > 0;) {
    copy.write({bytes.data(), static_cast<std::size_t>(source.gcount())});
  }
  if (!source.eof()) throw std::runtime_error("cannot read " + from.string());
  copy.commit();
}

void check_standard_output() {
  std::cout.flush();
  if (!std::cout) {
    throw std::runtime_error(std::string("cannot write to standard output: ") +
                             std::strerror(errno));
  }
}

}  // namespace cs550::files
