#pragma once
/// @file graded_test.hpp
/// A GoogleTest test that carries points.

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace cs550::autograder {

/// The duration of a test: one over 0.5 s at -O1 is Long and runs after the others.
enum class Duration { Short, Long };

/// The entry of a graded test in the manifest.
struct GradedTestInfo {
  std::string suite;  ///< "Lab3"
  std::string name;   ///< the property that the test checks
  std::string file;   ///< relative to the root; a test in a folder `hidden` is hidden
  int line = 0;       ///< of the GRADED_TEST in that file
  int points = 0;     ///< awarded together or not at all
  std::string step;   ///< "L3.2"
  Duration duration = Duration::Short;  ///< as measured at -O1

  /// The name in GoogleTest and ctest, "Lab3.Property".
  std::string full_name() const { return suite + "." + name; }
  /// Whether the students' copy lacks this test.
  bool hidden() const { return file.find("/hidden/") != std::string::npos; }
  /// The number of the lab, from the suite: 3 for "Lab3".
  int lab() const { return std::stoi(suite.substr(3)); }
};

/// All graded tests of this program, in the order of the manifest: by file and line, visible first.
std::vector<GradedTestInfo> graded_tests();

/// The base of every graded test. Turns exceptions from the body into a verdict.
class GradedTest : public testing::Test {
 protected:
  using enum Duration;  // lets a test say `Long`

  virtual void run() = 0;  ///< the body that follows GRADED_TEST

 private:
  void TestBody() final;

  GradedTestInfo info_;

  template <typename Test>
  friend bool register_graded_test(GradedTestInfo info);
};

/// Adds a test to the list. A second test with the same name is an error.
void remember_graded_test(const GradedTestInfo& info);

/// Makes GoogleTest run `Test`; always true, so that a static variable can call it.
template <typename Test>
bool register_graded_test(GradedTestInfo info) {
  remember_graded_test(info);
  testing::RegisterTest(info.suite.c_str(), info.name.c_str(), nullptr, nullptr, info.file.c_str(),
                        info.line, [info]() -> GradedTest* {
                          auto* test = new Test;
                          test->info_ = info;
                          return test;
                        });
  return true;
}

}  // namespace cs550::autograder

/// `GRADED_TEST(Lab3, HillClimbMatchesBruteForce, 6, "L3.2") { ... }`
///
/// Arguments: lab, property, points, step, and `Long` for a test over 0.5 s at -O1.
#define GRADED_TEST(suite_name, test_name, ...)                                   \
  class suite_name##_##test_name final : public ::cs550::autograder::GradedTest { \
   public:                                                                        \
    static ::cs550::autograder::GradedTestInfo info() {                           \
      return {#suite_name, #test_name, __FILE__, __LINE__, __VA_ARGS__};          \
    }                                                                             \
                                                                                  \
   private:                                                                       \
    void run() override;                                                          \
  };                                                                              \
  [[maybe_unused]] const bool suite_name##_##test_name##_is_registered =          \
      ::cs550::autograder::register_graded_test<suite_name##_##test_name>(        \
          suite_name##_##test_name::info());                                      \
  void suite_name##_##test_name::run()
