#pragma once
/// @file known_causes.hpp
/// Which tests fail for a cause that a test names: a test that passes excludes causes.

#include <set>
#include <string>
#include <vector>

namespace cs550::cli {

/// A mistake that was tried on the reference (tests/mutants/).
struct KnownCause {
  std::string words;                   ///< part of the cause as tests name it
  std::set<std::string> tests;         ///< visible tests of its step that fail for it
  std::set<std::string> elsewhere;     ///< those of other steps
  std::set<std::string> endless = {};  ///< tests of its step that may never end for it
};

/// From tests/labN_topic/causes.json; none where that file is absent.
std::vector<KnownCause> known_causes(const std::string& lab_name);

/// The tests of a lab that ran, by their outcome.
struct Outcomes {
  std::set<std::string> passed;
  std::set<std::string> failed;   ///< including those that were stopped
  std::set<std::string> stopped;  ///< as endless loops
};

/// The causes that no passing test of their step excludes. A cause for which every test of its step never
/// ends is excluded if all tests ended. Those that explain the most endless loops come first, then those
/// that explain the most failing tests of the step. Among equal ones, the tests of other steps decide: a
/// similar mistake may pass one of them, so they exclude nothing. None is left if the mistake is not one that was
/// tried.
std::vector<std::string> plausible(const std::vector<std::string>& causes,
                                   const std::vector<KnownCause>& known, const Outcomes& outcomes);

/// Those causes for which a test that was stopped may never end, in the same order.
std::vector<std::string> endless_causes(const std::vector<std::string>& causes,
                                        const std::vector<KnownCause>& known,
                                        const Outcomes& outcomes);

}  // namespace cs550::cli
