#pragma once
/// @file challenge.hpp
/// Counts that a student can improve after all tests of a lab pass. They earn no points.

#include <functional>
#include <string>
#include <vector>

namespace cs550::autograder {

/// Which of two counts is the better one.
enum class Better { Fewer, More };

/// Something to count, not to time, so that every machine gets the same number.
struct Challenge {
  std::string what;               ///< "vertices visited by 1000 climbs on a sphere"
  Better better = Better::Fewer;  ///< which way to go
  std::function<long()> count;    ///< runs the lab's code
};

/// The challenges of this program.
const std::vector<Challenge>& challenges();

/// Adds one; always true, so that a static variable can call it.
bool add_challenge(Challenge challenge);

}  // namespace cs550::autograder
