#include "cli/grading/crash_report.hpp"

#include <cstdlib>
#include <sstream>
#include <string_view>

namespace cs550::cli {
namespace {

bool begins_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// The rest of the line after a mark; empty where there is no mark.
std::string_view after(std::string_view line, std::string_view mark) {
  const std::size_t place = line.find(mark);
  return place == std::string_view::npos ? std::string_view() : line.substr(place + mark.size());
}

std::string_view before(std::string_view line, std::string_view mark) {
  return line.substr(0, line.find(mark));
}

void erase_all(std::string& text, std::string_view part) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part)) {
    text.erase(at, part.size());
  }
}

/// From `    #3 0x55 in cs550::support(cs550::PosedShape const&) labs/lab3/topic.cpp:45`:
/// `support, labs/lab3/topic.cpp:45`. Empty unless the place is in the student's or the tests'
/// code, which are named relative to the root.
std::string place_of_frame(std::string_view line) {
  const std::string_view where = line.substr(line.rfind(' ') + 1);
  const bool in_tests = begins_with(where, "tests/");
  if (!in_tests && !begins_with(where, "labs/")) return {};
  if (in_tests) return "the test, " + std::string(where);
  std::string function(before(after(line, " in "), " labs/"));
  erase_all(function, "cs550::");
  erase_all(function, "(anonymous namespace)::");
  return std::string(before(function, "(")) + ", " + std::string(where);
}

/// The place in a line such as `lab5_student: framework/include/a.hpp:51: f(): Assertion ...`. Empty unless it is in a
/// header of the contract, where a comment states the precondition.
std::string given_place(std::string_view line) {
  const std::string_view place = before(after(line, ": "), ": ");
  const std::size_t start = place.find("framework/include/");
  return start == std::string_view::npos ? "" : "\n  at " + std::string(place.substr(start));
}

/// What happened, from the line that reports it; empty for every other line.
std::string headline(std::string_view line) {
  if (const auto what = after(line, "ERROR: AddressSanitizer: "); !what.empty()) {
    if (begins_with(what, "ABRT ")) return "aborted";
    return "memory error: " + std::string(before(before(what, " on "), " ("));
  }
  if (const auto what = after(line, "runtime error: "); !what.empty()) {
    return "undefined behaviour: " + std::string(what);
  }
  if (contains(line, "hard rss limit exhausted")) {
    return "it allocated too much memory (a loop that adds elements without end?)";
  }
  const std::string_view assertion = after(line, "Assertion ");
  return assertion.empty() ? "" : "assertion " + std::string(assertion) + given_place(line);
}

/// A detail of it, from a line that has one; empty for every other line.
std::string detail(std::string_view line) {
  if (begins_with(line, "READ of size") || begins_with(line, "WRITE of size")) {
    return std::string(before(line, " at 0x"));
  }
  if (const auto where = after(line, " is located "); !where.empty()) {
    return std::string(before(where, " ["));
  }
  return std::string(after(line, "==Hint: "));
}

/// The title of a further stack in a report: where memory was allocated or freed.
std::string stack_title(std::string_view line) {
  if (begins_with(line, "freed by thread")) return "freed in";
  const bool allocated =
      begins_with(line, "allocated by thread") || begins_with(line, "previously allocated by");
  return allocated ? "allocated in" : "";
}

}  // namespace

std::string crash_report(const std::string& output) {
  constexpr int most_frames = 4;
  std::istringstream lines(output);
  std::string report;
  std::string title = "in";
  int frames = 0;
  for (std::string line; std::getline(lines, line);) {
    if (report.empty()) {
      const std::string what = headline(line);
      if (!what.empty()) report = what + '\n';
    } else if (contains(line, "SUMMARY: ")) {
      break;  // the rest is about addresses
    } else if (const std::string more = detail(line); !more.empty()) {
      report += more + '\n';
    } else if (const std::string next = stack_title(line); !next.empty()) {
      title = next;
      frames = 0;
    } else if (const std::string place = place_of_frame(line); !place.empty()) {
      if (frames < most_frames)
        report += "  " + (frames == 0 ? title : "from") + ' ' + place + '\n';
      ++frames;
    }
  }
  return report;
}

std::string calls_in(const std::string& report) {
  const std::size_t end = report.find('\n');
  return end == std::string::npos ? "" : report.substr(end + 1);
}

void configure_sanitizers() {
  constexpr int keep_the_users = 0;
  setenv("UBSAN_OPTIONS", "print_stacktrace=1", keep_the_users);
  setenv("ASAN_OPTIONS", "handle_abort=1:hard_rss_limit_mb=4096", keep_the_users);
}

}  // namespace cs550::cli
