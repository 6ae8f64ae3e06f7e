/// The other lab.
#include "functions.hpp"

namespace cs550 {

inline int number = 2;
[[gnu::noinline]] inline int helper() { return number; }

int other() { return helper(); }

}  // namespace cs550
