#include "gradebook/intake/read_archive.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <locale.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <initializer_list>
#include <memory>
#include <string_view>
#include <system_error>

#include "gradebook/text/escape.hpp"

namespace cs550::gradebook {
namespace {

using Archive = std::unique_ptr<archive, decltype(&archive_read_free)>;

/// libarchive converts names to the encoding of the locale, and loses those that it does not have. Within this scope it
/// has all, in this thread only. Numbers and messages stay as they are.
class Utf8Names {
 public:
  Utf8Names() : utf8_(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)), former_(uselocale(utf8_)) {}
  ~Utf8Names() {
    uselocale(former_);
    if (utf8_ != nullptr) freelocale(utf8_);
  }
  Utf8Names(const Utf8Names&) = delete;
  Utf8Names& operator=(const Utf8Names&) = delete;

 private:
  locale_t utf8_;  ///< null on a system without it: uselocale() then changes nothing
  locale_t former_;
};

Archive new_archive() {
  Archive reader(archive_read_new(), archive_read_free);
  archive_read_support_filter_gzip(reader.get());
  archive_read_support_format_tar(reader.get());
  archive_read_support_format_zip(reader.get());
  return reader;
}

std::string error_of(archive* reader) {
  const char* reason = archive_error_string(reader);
  return plain_line(reason == nullptr ? "unknown" : reason);
}

/// Opens a file. @return why that is not possible; empty if it is
std::string open_file(archive* reader, const std::filesystem::path& file) {
  constexpr std::size_t block = 64 * 1024;
  std::error_code reason;
  const std::filesystem::file_status status = std::filesystem::status(file, reason);
  if (!reason && !std::filesystem::is_regular_file(status)) return "not a file";
  if (!reason && faccessat(AT_FDCWD, file.c_str(), R_OK, AT_EACCESS) != 0) {
    reason = {errno, std::generic_category()};
  }
  if (reason) return "cannot be read: " + reason.message();
  if (archive_read_open_filename(reader, file.c_str(), block) == ARCHIVE_OK) return {};
  return fmt::format("not a zip or tar archive ({})", error_of(reader));
}

std::string path_of(archive_entry* entry) {
  if (const char* path = archive_entry_pathname_utf8(entry)) return path;
  const char* path = archive_entry_pathname(entry);
  return path == nullptr ? "" : path;
}

/// Why an entry is not even considered; empty for a file.
std::string fault_of_type(archive_entry* entry) {
  if (archive_entry_hardlink(entry) != nullptr) return "hard link";
  if (archive_entry_symlink(entry) != nullptr) return "symbolic link";
  if (archive_entry_filetype(entry) != AE_IFREG) return "neither a file nor a folder";
  if (archive_entry_is_encrypted(entry) == 1) return "encrypted";
  return {};
}

/// Reads the content of an entry, up to one byte more than `most`: its declared size may be a lie.
/// @return whether it could be read
bool read_content(archive* from, std::size_t most, std::string& content) {
  std::array<char, 16 * 1024> buffer{};
  for (;;) {
    const la_ssize_t bytes = archive_read_data(from, buffer.data(), buffer.size());
    if (bytes <= 0) return bytes == 0;
    content.append(buffer.data(), static_cast<std::size_t>(bytes));
    if (content.size() > most) return true;
  }
}

bool ends_with_any(const std::filesystem::path& file,
                   std::initializer_list<std::string_view> endings) {
  std::string name = file.filename();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::any_of(endings.begin(), endings.end(), [&name](std::string_view ending) {
    return name.size() > ending.size() && name.ends_with(ending);
  });
}

std::string damage(archive* damaged) {
  return fmt::format("a damaged archive: {}", error_of(damaged));
}

}  // namespace

bool is_archive(const std::filesystem::path& file) {
  return ends_with_any(file, {".zip", ".tar", ".tar.gz", ".tgz"});
}

bool is_unknown_archive(const std::filesystem::path& file) {
  return ends_with_any(file, {".rar", ".7z", ".xz", ".bz2", ".zst", ".gz"}) && !is_archive(file);
}

std::string read_archive(const std::filesystem::path& file, Collector& collector,
                         const IntakeLimits& limits) {
  const Utf8Names names;
  const Archive opened = new_archive();
  if (std::string fault = open_file(opened.get(), file); !fault.empty()) return fault;
  std::size_t unpacked = 0;
  int entries = 0;
  archive_entry* entry = nullptr;
  for (;;) {
    const int result = archive_read_next_header(opened.get(), &entry);
    if (result == ARCHIVE_EOF) break;
    if (result != ARCHIVE_OK && result != ARCHIVE_WARN) return damage(opened.get());
    if (++entries > limits.entries) {
      return fmt::format("the archive has more than {} entries", limits.entries);
    }
    const std::string path = path_of(entry);
    const bool is_folder = archive_entry_filetype(entry) == AE_IFDIR;
    const std::string fault = is_folder ? "" : fault_of_type(entry);
    if (!fault.empty()) collector.ignore(path, fault);
    const bool wanted = !is_folder && fault.empty() && collector.wants(path);
    // Content that is not wanted is read too: only that limits what a bomb costs.
    std::string content;
    const bool is_whole = read_content(opened.get(), limits.unpacked - unpacked, content);
    unpacked += content.size();
    if (unpacked > limits.unpacked) {
      return fmt::format("the archive unpacks to more than {} MB", limits.unpacked >> 20U);
    }
    if (!wanted) continue;
    if (!is_whole) return damage(opened.get());
    collector.take(path, std::move(content));
  }
  return entries == 0 ? "an empty archive" : "";
}

}  // namespace cs550::gradebook
