/// A lab with helpers whose names another lab uses for different helpers.
#include "functions.hpp"

namespace cs550 {

inline int number = 1;
[[gnu::noinline]] inline int helper() { return number; }

int one() { return helper(); }

}  // namespace cs550
