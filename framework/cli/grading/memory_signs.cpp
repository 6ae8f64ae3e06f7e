#include "cli/grading/memory_signs.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <optional>
#include <regex>

#include "cli/grading/graded_run.hpp"

namespace cs550::cli {
namespace {

/// While this object lives, programs that are started fill memory that they free, where the C library is
/// glibc. Its caches of small blocks would leave most of a block as it was.
class FilledFreedMemory {
 public:
  FilledFreedMemory() {
    if (const char* tunables = std::getenv(name)) former_ = tunables;
    setenv(name, "glibc.malloc.tcache_count=0:glibc.malloc.perturb=165", 1);
  }
  ~FilledFreedMemory() {
    if (former_) {
      setenv(name, former_->c_str(), 1);
    } else {
      unsetenv(name);
    }
  }
  FilledFreedMemory(const FilledFreedMemory&) = delete;
  FilledFreedMemory& operator=(const FilledFreedMemory&) = delete;

 private:
  static constexpr const char* name = "GLIBC_TUNABLES";
  std::optional<std::string> former_;
};

bool compared_values(const Verdict& verdict) {
  return verdict.kind == Verdict::Kind::Failed && verdict.ending.empty() &&
         verdict.message.rfind("not implemented: ", 0) != 0;
}

bool got_nan(const std::string& report) {
  static const std::regex line(R"((^|\n)  got [^\n]*\bnan\b)");
  return std::regex_search(report, line);
}

/// Whether the report of a test is another one if freed memory has other contents. A machine that is too
/// busy to run the test proves nothing.
bool depends_on_freed_memory(const std::filesystem::path& program, int lab, const Verdict& failure,
                             const Limits& limits) {
  constexpr std::chrono::seconds patience{5};
  const FilledFreedMemory filled;
  const Verdict again =
      run_graded_tests(program, lab, {failure.test}, patience, {}, limits).front();
  return again.ending.rfind("stopped", 0) != 0 && again.message != failure.message;
}

}  // namespace

std::string memory_advice(const std::filesystem::path& program, int lab, const Verdict& failure,
                          const Limits& limits) {
  if (!compared_values(failure)) return {};
  std::string sign;
  if (!failure.test.is_long && depends_on_freed_memory(program, lab, failure, limits)) {
    sign =
        " gets other values if freed memory has other contents. So the code reads memory that "
        "was freed or never set";
  } else if (got_nan(failure.message)) {
    sign =
        " got a value that is not a number. If no division or root explains it, the code may "
        "read memory that was freed or never set";
  } else {
    return {};
  }
  return failure.test.name + sign +
         fmt::format(
             ", for example through a std::span or pointer to a temporary:\n"
             "try  ./cs550 lab {} --asan  which prints the line of a memory error\n",
             lab);
}

}  // namespace cs550::cli
