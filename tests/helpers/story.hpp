#pragma once
/// @file story.hpp
/// Checks that explain their failure: the property in words, the case, what was expected and found
/// with units, and the likely causes. The failed checks of a test become one block
/// (test_report.hpp).

#include <concepts>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <cs550/test_report.hpp>

#include "cs550/math.hpp"

namespace cs550::test {

/// The line of a check in the test's source.
struct SourceLine {
  const char* file;
  int line;
  // Implicit, with defaults here, so that they are the line of the caller.
  SourceLine(const char* at_file = __builtin_FILE(), int at_line = __builtin_LINE())
      : file(at_file), line(at_line) {}
};

/// One property and the case in which it is checked. Copy a story to vary a case in a loop.
/// Describe the case before calling the student's code. If that crashes or never returns, the
/// report shows the last case described.
class Story {
 public:
  /// @param property a sentence: "Free fall follows x₀ + v₀·t + ½·g·t²"
  explicit Story(std::string property);

  /// A fact about the case, in words.
  Story& given(const std::string& fact);
  template <class Value>
  Story& given(const std::string& name, const Value& value, const std::string& unit = "") {
    return given(name + " = " + show(value, unit));
  }
  /// The action under test.
  Story& when(const std::string& action);
  /// The seed of the random inputs.
  Story& seed(std::uint32_t seed);
  /// The most likely mistake, in the student's terms.
  Story& likely(const std::string& cause);
  /// A picture as SVG, drawn only if a check of this story fails. Objects that the function refers
  /// to must live until then. Only the simplest failing case of a test is drawn (picture.hpp).
  Story& picture(std::function<std::string()> draw);

  // Each check returns whether it passed, so that a loop can stop at its first failure. The sign of
  // a tolerance is ignored, so that it can be a fraction of an expected value of either sign.

  bool expect(const std::string& what, bool holds, SourceLine at = {});
  /// A check whose two sides are described in words.
  bool expect(const std::string& what, bool holds, const std::string& got,
              const std::string& expected, SourceLine at = {});
  /// |got − expected| ≤ tolerance; false for NaN.
  bool expect_near(const std::string& what, double got, double expected, double tolerance,
                   const std::string& unit = "", SourceLine at = {});
  /// ‖got − expected‖ ≤ tolerance; false for NaN.
  bool expect_near(const std::string& what, const Vec3& got, const Vec3& expected, double tolerance,
                   const std::string& unit = "", SourceLine at = {});
  bool expect_at_most(const std::string& what, double got, double bound,
                      const std::string& unit = "", SourceLine at = {});
  bool expect_at_least(const std::string& what, double got, double bound,
                       const std::string& unit = "", SourceLine at = {});
  /// Whether an index is one of `count` elements.
  bool expect_index(const std::string& what, Index index, Index count, SourceLine at = {});
  template <class Got, class Expected>
  bool expect_equal(const std::string& what, const Got& got, const Expected& expected,
                    SourceLine at = {}) {
    return got == expected ? passed() : failed(what, show(got, ""), show(expected, ""), at);
  }

  // Numbers have seven significant digits, enough to tell two floats apart by eye.
  static std::string show(double value, const std::string& unit = "");
  static std::string show(const Vec3& value, const std::string& unit = "");
  static std::string show(const Quat& value, const std::string& unit = "");
  static std::string show(const std::string& text, const std::string& unit = "");
  /// "1, 4, 7"; "none" if there are none.
  template <class Items>
  static std::string show(const Items& items) requires std::integral<typename Items::value_type> &&
      (!std::same_as<typename Items::value_type, char>) {
    std::string list;
    for (const auto item : items) list += (list.empty() ? "" : ", ") + std::to_string(item);
    return list.empty() ? "none" : list;
  }
  // Includes bool, which as the type of a parameter would take text in quotes too.
  static std::string show(std::integral auto value, const std::string& unit = "") {
    if constexpr (std::same_as<decltype(value), bool>)
      return value ? "yes" : "no";
    else
      return show(std::to_string(value), unit);
  }

 private:
  // The two outcomes of a check, with its return value.
  static bool passed();
  bool failed(const std::string& what, const std::string& got, const std::string& expected,
              SourceLine at) const;

  autograder::TestCase case_;
  std::function<std::string()> draw_;
};

}  // namespace cs550::test
