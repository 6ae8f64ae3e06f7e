#include <span>
#include <vector>

#include "cs550/convex_shape.hpp"
// From here on, values have their members at other places than the judge expects.
#define Index long long
#define vertex visited
#define visited vertex
#include "in_each_function.hpp"
void attack::run() {}
