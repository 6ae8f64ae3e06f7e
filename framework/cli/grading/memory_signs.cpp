#include "cli/grading/memory_signs.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <optional>
#include <regex>

#include "cli/grading/graded_run.hpp"
#include "cli/system/draft_folder.hpp"
#include "cli/system/project.hpp"

namespace cs550::cli {
namespace {

/// While this object lives, a variable of the environment has another value, also in programs that are started.
class Setting {
 public:
  Setting(const char* name, const std::string& value) : name_(name) {
    if (const char* former = std::getenv(name)) former_ = former;
    setenv(name, value.c_str(), 1);
  }
  ~Setting() {
    if (former_) {
      setenv(name_, former_->c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

 private:
  const char* name_;
  std::optional<std::string> former_;
};

/// Makes glibc fill memory that is freed. Its caches of small blocks would leave most of a block as it was.
class FilledFreedMemory {
 private:
  Setting tunables_{"GLIBC_TUNABLES", "glibc.malloc.tcache_count=0:glibc.malloc.perturb=165"};
};

/// The tests that run meanwhile do not replace the pictures of the failures that were reported.
class OtherPictures {
 public:
  OtherPictures() { remove_abandoned_drafts(wanted()); }

 private:
  static std::filesystem::path wanted() { return project_root() / "build/results/repeated"; }

  DraftFolder folder_{wanted()};
  Setting pictures_{"CS550_PICTURES", folder_.path()};
};

bool compared_values(const Verdict& verdict) {
  return verdict.kind == Verdict::Kind::Failed && verdict.ending.empty() &&
         verdict.message.rfind("not implemented: ", 0) != 0;
}

bool got_nan(const std::string& report) {
  static const std::regex line(R"((^|\n)  got [^\n]*\bnan\b)");
  return std::regex_search(report, line);
}

/// A report without the line that names its picture.
std::string without_picture(const std::string& report) {
  static const std::regex line(R"((^|\n) *picture +[^\n]*)");
  return std::regex_replace(report, line, "");
}

/// What a failed test reports when it runs again, in a process of its own. Nothing if the machine is too busy to
/// run it.
std::optional<std::string> repeated_report(const std::filesystem::path& program, int lab,
                                           const Verdict& failure, const Limits& limits) {
  constexpr std::chrono::seconds patience{5};
  const OtherPictures other;
  const Verdict again =
      run_graded_tests(program, lab, {failure.test}, patience, {}, limits).front();
  if (again.ending.rfind("stopped", 0) == 0) return std::nullopt;
  return without_picture(again.message);
}

enum class Cause { Unknown, EarlierTests, MemoryOrChance, Memory };

/// What changes the values of a failed test.
Cause cause_of_change(const std::filesystem::path& program, int lab, const Verdict& failure,
                      const Limits& limits) {
  const std::optional<std::string> alone = repeated_report(program, lab, failure, limits);
  if (!alone) return Cause::Unknown;
  const FilledFreedMemory other_contents;
  const std::optional<std::string> filled = repeated_report(program, lab, failure, limits);
  const bool changes_alone = *alone != without_picture(failure.message);
  if (filled && *filled != *alone) return changes_alone ? Cause::MemoryOrChance : Cause::Memory;
  return changes_alone ? Cause::EarlierTests : Cause::Unknown;
}

}  // namespace

std::string memory_advice(const std::filesystem::path& program, int lab, const Verdict& failure,
                          const Limits& limits) {
  if (!compared_values(failure)) return {};
  const std::string& test = failure.test.name;
  const std::string asan =
      fmt::format("try  ./cs550 lab {} --asan  which prints the line of a memory error\n", lab);
  const std::string memory =
      "memory that was freed or never set, for example through a std::span or pointer to a "
      "temporary";
  switch (failure.test.is_long ? Cause::Unknown : cause_of_change(program, lab, failure, limits)) {
    case Cause::Memory:
      return test + " gets other values if freed memory has other contents. So the code reads " +
             memory + ":\n" + asan;
    case Cause::MemoryOrChance:
      return test + " gets other values each time it runs. The code may use random numbers, or " +
             "read " + memory + ":\n" + asan;
    case Cause::EarlierTests:
      if (got_nan(failure.message)) break;
      return test + " gets other values if it runs alone. A static or global variable may keep " +
             "its value from one test to the next, or a local one may be read before it is set.\n";
    case Cause::Unknown:
      break;
  }
  if (!got_nan(failure.message)) return {};
  return test + " got a value that is not a number. If no division or root explains it, the code " +
         "may read " + memory + ":\n" + asan;
}

}  // namespace cs550::cli
