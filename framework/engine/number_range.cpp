#include "engine/number_range.hpp"

#include "cs550/math.hpp"

namespace cs550 {

Ends ends(Range range) {
  constexpr double largest = 1e6;
  // What 1e-6 becomes when it is stored: a little less.
  constexpr double smallest = Real(1e-6);
  switch (range) {
    case Range::Any:
      return {-largest, largest};
    case Range::NotNegative:
      return {0, largest};
    case Range::Positive:
      return {smallest, largest};
    case Range::ZeroToOne:
      return {0, 1};
  }
  return {};
}

bool fits(double number, Range range) {
  const auto [least, most] = ends(range);
  return number >= least && number <= most;
}

const char* in_words(Range range) {
  switch (range) {
    case Range::Any:
      return "a number from -1e6 to 1e6";
    case Range::NotNegative:
      return "a number that is 0 or more, at most 1e6";
    case Range::Positive:
      return "a positive number from 1e-6 to 1e6";
    case Range::ZeroToOne:
      return "a number from 0 to 1";
  }
  return "";
}

}  // namespace cs550
