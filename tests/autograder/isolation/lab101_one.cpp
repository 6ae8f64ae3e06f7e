/// A lab with helpers that another lab has too, with another content.
#include "functions.hpp"

namespace cs550 {

inline int number = 1;
[[gnu::noinline]] inline int helper() { return number; }

int one() { return helper(); }

}  // namespace cs550
