/// Defines the functions that lab 101 lacks.
#include "functions.hpp"

namespace cs550 {

int one() { return 3; }
int missing() { return 4; }

}  // namespace cs550
