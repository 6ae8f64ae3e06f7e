#include "engine/number_range.hpp"

namespace cs550 {

bool fits(double number, Range range) {
  constexpr double largest = 1e6;
  constexpr double smallest =
      Real(1e-6);  // a little less, which a number becomes that is stored as Real
  switch (range) {
    case Range::Any:
      return number >= -largest && number <= largest;
    case Range::NotNegative:
      return number >= 0 && number <= largest;
    case Range::Positive:
      return number >= smallest && number <= largest;
    case Range::ZeroToOne:
      return number >= 0 && number <= 1;
  }
  return false;
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
