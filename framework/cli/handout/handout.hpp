#pragma once
/// @file handout.hpp
/// The handout parser: the steps of labs/labN_topic/README.md and their hints, printed one at a
/// time.

#include <string>
#include <vector>

namespace cs550::cli {

/// A hint: a <details> block of the handout.
struct Hint {
  std::string question;  ///< the summary, "Where are the neighbours?"
  std::string answer;    ///< with formulas in plain characters
};

/// A step: the section `## L3.2 Climb`.
struct Step {
  std::string tag;    ///< "L3.2"
  std::string title;  ///< "Climb"
  std::vector<Hint> hints;
};

/// The steps of a lab in the order of the handout; none when there is no handout.
std::vector<Step> handout_steps(const std::string& lab_name);

/// The step with this tag; a step without title and hints when the handout does not have it.
Step handout_step(const std::string& lab_name, const std::string& tag);

/// The tags of a lab's steps in the order in which the handout advises to write them; none if it
/// does not state an order.
std::vector<std::string> writing_order(const std::string& lab_name);

/// Prints a hint of a step.
/// @param number 1, 2, 3; 0 prints the one after the last that was printed
/// (build/results/hints.json)
/// @return an ExitCode: Misused when the handout has no such hint
int show_hint(const std::string& lab_name, const std::string& tag, int number);

}  // namespace cs550::cli
