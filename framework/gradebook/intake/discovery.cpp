#include "gradebook/intake/discovery.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>
#include <stdexcept>

#include "files/source_name.hpp"
#include "gradebook/intake/lab_path.hpp"
#include "gradebook/intake/read_archive.hpp"
#include "gradebook/intake/read_folder.hpp"
#include "gradebook/text/escape.hpp"

namespace cs550::gradebook {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> entries(const fs::path& folder, bool links) {
  std::vector<fs::path> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_symlink() == links) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::vector<fs::path> children(const fs::path& folder) { return entries(folder, false); }
std::vector<fs::path> links(const fs::path& folder) { return entries(folder, true); }

bool is_some_archive(const fs::path& file) { return is_archive(file) || is_unknown_archive(file); }

/// Whether a folder with this name is that of a lab.
bool names_a_lab(const std::string& folder, const Catalogue& catalogue) {
  return lab_path(folder + "/a.cpp", catalogue).lab != 0;
}

/// Whether a folder holds submissions, whatever its name is: an archive is in it, or in a folder in it, and no code
/// is directly in it.
bool holds_archives(const fs::path& folder) {
  constexpr auto options = fs::directory_options::skip_permission_denied;
  bool has_archives = false;
  fs::recursive_directory_iterator entry(folder, options);
  for (; entry != fs::recursive_directory_iterator(); ++entry) {
    if (entry.depth() == 0 && files::is_source(entry->path())) return false;
    if (entry.depth() == 1) entry.disable_recursion_pending();
    has_archives = has_archives || is_some_archive(entry->path());
  }
  return has_archives;
}

/// Whether a folder is a submission, not a folder of submissions.
bool has_lab_files(const fs::path& folder, const Catalogue& catalogue) {
  for (const fs::path& child : children(folder)) {
    const std::string name = child.filename();
    if (name == "labs" || name == ".git") return true;
    const bool is_of_lab = fs::is_directory(child)
                               ? names_a_lab(name, catalogue) && !holds_archives(child)
                               : lab_path(name, catalogue).lab != 0;
    if (is_of_lab) return true;
  }
  return false;
}

std::string stem(const fs::path& source) { return without_ending(source.filename()); }

/// "ada-lab3" and "ada_labs" were handed in by ada.
std::string student_of(const std::string& name) {
  static const std::regex lab_at_the_end("(.+?)[-_. ]labs?[0-9]*", std::regex::icase);
  std::smatch match;
  return std::regex_match(name, match, lab_at_the_end) ? match[1].str() : name;
}

std::optional<long> modification_time(const fs::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0 || S_ISDIR(status.st_mode)) return std::nullopt;
  return status.st_mtime;
}

/// Walks through folders of submissions.
class Finder {
 public:
  explicit Finder(const Catalogue& catalogue) : catalogue_(catalogue) {}

  /// @param folders the names of the folders between the source and this path
  void look_at(const fs::path& path, const std::vector<std::string>& folders) {
    if (!fs::is_directory(path)) {
      // One that cannot be read is what a student handed in, too.
      if (is_some_archive(path)) {
        add(path, folders);
      } else {
        skip(path, "not an archive");
      }
    } else if (has_lab_files(path, catalogue_)) {
      add(path, folders);
    } else if (folders.size() <= deepest) {
      open(path, folders);
    } else if (!skip_too_deep(path)) {
      skip(path, no_files);
    }
  }

  void open(const fs::path& folder, const std::vector<std::string>& folders) {
    const std::size_t before = found_.submissions.size();
    const std::size_t skipped_before = found_.skipped.size();
    for (const fs::path& link : links(folder)) {
      skip(link, "a symbolic link, which is not followed");
    }
    for (const fs::path& child : children(folder)) {
      std::vector<std::string> names = folders;
      if (fs::is_directory(child)) names.push_back(child.filename());
      look_at(child, names);
    }
    if (found_.submissions.size() > before) return;
    // A folder without a submission is what a student handed in, and gets a record, which lists the files in it. A
    // single folder in it that is too deep is graded then.
    const auto skipped = found_.skipped.begin() + static_cast<std::ptrdiff_t>(skipped_before);
    const auto deep = std::count_if(skipped, found_.skipped.end(), [](const IgnoredFile& file) {
      return file.reason == too_deep;
    });
    const auto is_in_record = [deep](const IgnoredFile& file) {
      return file.reason == no_files || (file.reason == too_deep && deep == 1);
    };
    found_.skipped.erase(std::remove_if(skipped, found_.skipped.end(), is_in_record),
                         found_.skipped.end());
    const std::size_t above = folders.empty() ? 0 : folders.size() - 1;
    add(folder, {folders.begin(), folders.begin() + static_cast<std::ptrdiff_t>(above)});
  }

  Discovery result() { return std::move(found_); }

 private:
  static constexpr std::size_t deepest = 2;  ///< a folder per student, and one per lab in it
  static constexpr const char* no_files = "no files of a lab, three folders deep";
  static constexpr const char* too_deep = "too deep to be a submission of its own";

  void skip(const fs::path& path, const char* reason) {
    found_.skipped.push_back({plain_line(path.string()), reason, 1});
  }

  /// Notes what could be submissions in a folder that is deeper than these are. @return whether there are any
  bool skip_too_deep(const fs::path& folder) {
    if (has_lab_files(folder, catalogue_)) {
      skip(folder, too_deep);
      return true;
    }
    bool has_some = false;
    bool has_archives = false;
    for (const fs::path& child : children(folder)) {
      has_some = (fs::is_directory(child) && skip_too_deep(child)) || has_some;
      has_archives = has_archives || is_some_archive(child);
    }
    if (has_archives) skip(folder, "its archives are too deep: not read");
    return has_some || has_archives;
  }

  /// Whether a name is that of a lab, or of all: ./cs550 submit writes lab3.zip and labs.zip.
  bool is_no_student(const std::string& name) const {
    return name == "labs" || names_a_lab(name, catalogue_);
  }

  /// The name of the nearest folder around a source that may be a student's; empty if there is none.
  std::string folder_around(const fs::path& source) const {
    fs::path folder = source.parent_path();
    while (is_no_student(folder.filename())) folder = folder.parent_path();
    return folder.filename();
  }

  /// The student whose folder it is in, else whose name the file has.
  std::string student_of_source(const fs::path& source,
                                const std::vector<std::string>& folders) const {
    const std::vector<std::string> names = names_of_students(folders);
    return names.empty() ? student_of(stem(source)) : names.front();
  }

  /// The folders that may be a student's or a section's.
  std::vector<std::string> names_of_students(const std::vector<std::string>& folders) const {
    std::vector<std::string> names;
    for (const std::string& folder : folders) {
      if (!is_no_student(folder)) names.push_back(plain_line(folder));
    }
    return names;
  }

  void add(const fs::path& source, std::vector<std::string> folders) {
    if (!folders.empty() && folders.back() == source.filename()) folders.pop_back();
    // The folder of a student may have been named by itself, as GNU parallel does.
    if (is_no_student(student_of_source(source, folders))) {
      if (const std::string around = folder_around(source); !around.empty()) {
        folders.insert(folders.begin(), around);
      }
    }
    std::string name;
    for (const std::string& folder : folders) name += folder + '-';
    name = safe_name(name + stem(source));
    const std::string base = name;
    for (int n = 2; !names_.insert(name).second; ++n) name = base + '-' + std::to_string(n);
    found_.submissions.push_back({source, name, plain_line(student_of_source(source, folders)),
                                  modification_time(source), "", false,
                                  names_of_students(folders)});
  }

  const Catalogue& catalogue_;
  Discovery found_;
  std::set<std::string> names_;
};

}  // namespace

Discovery find_submissions(const std::vector<fs::path>& sources, const Catalogue& catalogue) {
  Finder finder(catalogue);
  for (const fs::path& source : sources) {
    // "class/" and "class" are the same folder.
    const fs::path path = fs::absolute(source / "").lexically_normal().parent_path();
    if (!fs::exists(path)) throw std::runtime_error("there is no submission " + source.string());
    if (!fs::is_directory(path) && !is_archive(path)) {
      throw std::runtime_error(source.string() +
                               " is no submission. Expected a .zip, .tar.gz or folder");
    }
    finder.look_at(path, {});
  }
  return finder.result();
}

std::string recorded_path(const FoundSubmission& found) {
  return plain_line(found.source.string());
}

Submission read_submission(const FoundSubmission& found, const Catalogue& catalogue) {
  Submission submission;
  submission.name = found.name;
  submission.source = plain_line(found.source.filename().string());
  submission.path = recorded_path(found);
  submission.student = found.student;
  submission.folders = found.folders;
  submission.is_identified = found.is_identified;
  submission.file_time = found.time;
  submission.trouble = found.trouble;
  if (!submission.trouble.empty()) return submission;
  Collector collector(submission, catalogue);
  try {
    submission.trouble = fs::is_directory(found.source) ? read_folder(found.source, collector)
                                                        : read_archive(found.source, collector);
  } catch (const std::exception& error) {
    submission.trouble = plain_line(error.what());
  }
  collector.finish();
  if (!submission.trouble.empty()) submission.labs.clear();
  return submission;
}

std::string without_ending(const std::string& name) {
  static const std::regex ending(R"((.+?)(\.zip|\.tar|\.tar\.gz|\.tgz|\.rar|\.7z)?)",
                                 std::regex::icase);
  std::smatch match;
  return std::regex_match(name, match, ending) ? match[1].str() : name;
}

std::string safe_name(const std::string& name) {
  constexpr std::size_t longest = 100;
  std::string safe = name.substr(0, longest);
  for (char& c : safe) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '-') c = '_';
  }
  return safe.empty() || safe[0] == '.' || safe[0] == '-' ? '_' + safe : safe;
}

}  // namespace cs550::gradebook
