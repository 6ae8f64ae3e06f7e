#pragma once
/// @file handout.hpp
/// What tools need from a handout, labs/labN_topic/README.md: the steps and their hints.

#include <string>
#include <vector>

namespace cs550::cli {

/// A hint as the handout hides it in <details>.
struct Hint {
  std::string question;  ///< the summary, "Where are the neighbours?"
  std::string answer;    ///< its formulas in plain characters
};

/// A step: the section `## L3.2 Climb`.
struct Step {
  std::string tag;    ///< "L3.2"
  std::string title;  ///< "Climb"
  std::vector<Hint> hints;
};

/// The steps of a lab in the handout's order; none when there is no handout.
std::vector<Step> handout_steps(const std::string& lab_name);

/// The step with this tag; a step without title and hints when the handout does not have it.
Step handout_step(const std::string& lab_name, const std::string& tag);

}  // namespace cs550::cli
