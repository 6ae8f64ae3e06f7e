#include <cs550/test_report.hpp>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <utility>

namespace cs550::autograder {
namespace {

constexpr std::size_t capacity = 16384;  ///< bytes; a longer text is cut
constexpr std::string_view before_check = "in this case:\n";
constexpr std::string_view after_check = "after this case, or in it:\n";

/// The text ends at its first zero. It is written without allocating: loops over thousands of cases
/// note each of them.
class Note {
 public:
  void move_to(char* memory) {
    text_ = memory;
    clear();
  }
  void move_home() { move_to(own_.data()); }
  const char* text() const { return text_; }

  void clear() { end(0); }
  void add(std::string_view part) {
    const std::size_t size = std::min(part.size(), capacity - 1 - size_);
    std::memcpy(text_ + size_, part.data(), size);
    end(size_ + size);
  }
  void add_list(std::string_view label, const std::vector<std::string>& items) {
    constexpr std::string_view blank = "            ";
    bool first = true;
    for (const std::string& item : items) {
      add(first ? label : blank);
      add(item);
      add("\n");
      first = false;
    }
  }
  /// Puts another heading in the place of the first one.
  void change_heading(std::string_view old, std::string_view heading) {
    if (std::string_view(text_, size_).substr(0, old.size()) != old) return;
    const std::size_t kept = std::min(size_ - old.size(), capacity - 1 - heading.size());
    std::memmove(text_ + heading.size(), text_ + old.size(), kept);
    std::memcpy(text_, heading.data(), heading.size());
    end(heading.size() + kept);
  }

 private:
  void end(std::size_t size) {
    size_ = size;
    text_[size_] = '\0';
  }

  std::array<char, capacity> own_{};
  char* text_ = own_.data();
  std::size_t size_ = 0;
};

Note& note() {
  static Note only;
  return only;
}

/// A new file of `capacity` bytes, seen as memory; null when that cannot be had.
char* map_file(const std::filesystem::path& file) {
  const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) return nullptr;
  void* memory = MAP_FAILED;
  if (ftruncate(descriptor, capacity) == 0) {
    memory = mmap(nullptr, capacity, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  }
  close(descriptor);
  return memory == MAP_FAILED ? nullptr : static_cast<char*>(memory);
}

}  // namespace

void note_case(const TestCase& at) {
  note().clear();
  if (at.property.empty()) return;
  note().add(before_check);
  note().add(at.property);
  note().add("\n");
  note().add_list("  given     ", at.given);
  note().add_list("  when      ", at.when);
  note().add_list("  likely    ", at.causes);
}

void note_passed_check() { note().change_heading(before_check, after_check); }

std::string noted_case() { return note().text(); }

CaseFile::CaseFile(std::filesystem::path file) : file_(std::move(file)) {
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::absolute(file_).parent_path(), error);
  if (char* memory = map_file(file_)) note().move_to(memory);
}

CaseFile::~CaseFile() {
  note().move_home();
  std::error_code gone_already;
  std::filesystem::remove(file_, gone_already);
}

}  // namespace cs550::autograder
