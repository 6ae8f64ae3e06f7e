#pragma once
/// @file number_range.hpp
/// The ranges of numbers that a scene or a program states.

#include <cstdint>

namespace cs550 {

/// What a number may be. Within these bounds squares and products of what a scene holds (an inertia is
/// density × length⁵) stay within the range of a float.
enum class Range : std::uint8_t { Any, NotNegative, Positive, ZeroToOne };

/// The least and the largest number of a range.
struct Ends {
  double least, most;
};
Ends ends(Range range);

/// Whether a number is within a range.
bool fits(double number, Range range);

/// "a positive number from 1e-6 to 1e6".
const char* in_words(Range range);

}  // namespace cs550
