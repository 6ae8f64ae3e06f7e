#include "cli/system/draft_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <regex>
#include <string>
#include <system_error>

namespace cs550::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* draft_mark = ".partial-";

/// Whether a name is `wanted.partial-PROCESS` or `wanted.partial-PROCESS-NUMBER`.
bool is_draft_of(const std::string& wanted, const std::string& name) {
  static const std::regex number("[0-9]+(-[0-9]+)?");
  const std::string start = wanted + draft_mark;
  return name.compare(0, start.size(), start) == 0 &&
         std::regex_match(name.substr(start.size()), number);
}

enum class Lock { Taken, InUse, Unsupported };

/// Takes the lock of an open folder. It ends with the process, however that ends.
Lock take_lock(int folder) {
  if (flock(folder, LOCK_EX | LOCK_NB) == 0) return Lock::Taken;
  return errno == EWOULDBLOCK ? Lock::InUse : Lock::Unsupported;
}

int open_folder(const fs::path& folder) {
  return open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

/// Whether the folder was removed after it had been opened.
bool is_gone(int folder) {
  struct stat status {};
  return fstat(folder, &status) != 0 || status.st_nlink == 0;
}

/// Whether another process took a new folder for abandoned, before this one had locked it.
bool is_lost(int folder, const fs::path& path) {
  if (folder < 0) return !fs::exists(path);
  return take_lock(folder) == Lock::InUse || is_gone(folder);
}

/// Whether a folder contains a draft, or nothing.
bool has_nothing_else(const fs::path& folder) {
  const auto is_draft = [](const fs::directory_entry& entry) {
    return entry.path().filename() == DraftFolder::content;
  };
  std::error_code unreadable;
  const fs::directory_iterator entries(folder, unreadable);
  return !unreadable && std::all_of(begin(entries), end(entries), is_draft);
}

}  // namespace

// Not by mkdtemp(), whose folder is closed to others: the wanted one follows the umask.
DraftFolder::DraftFolder(const fs::path& wanted) {
  fs::create_directories(wanted.parent_path());
  const std::string start = wanted.string() + draft_mark + std::to_string(getpid());
  outer_ = start;
  for (int i = 1;; ++i) {
    if (fs::create_directory(outer_)) {
      lock_ = open_folder(outer_);
      if (!is_lost(lock_, outer_)) break;
      close(lock_);
    }
    outer_ = start + '-' + std::to_string(i);
  }
  fs::create_directory(path());
}

DraftFolder::~DraftFolder() {
  std::error_code ignored;
  fs::remove_all(outer_, ignored);
  close(lock_);
}

std::vector<fs::path> remove_abandoned_drafts(const fs::path& wanted) {
  std::vector<fs::path> removed;
  std::error_code absent;
  for (const fs::directory_entry& entry : fs::directory_iterator(wanted.parent_path(), absent)) {
    if (!is_draft_of(wanted.filename().string(), entry.path().filename().string())) continue;
    const int folder = open_folder(entry.path());
    if (folder < 0) continue;
    if (take_lock(folder) == Lock::Taken && !is_gone(folder) && has_nothing_else(entry.path())) {
      std::error_code failed;
      fs::remove_all(entry.path(), failed);
      if (!failed) removed.push_back(entry.path());
    }
    close(folder);
  }
  return removed;
}

}  // namespace cs550::cli
