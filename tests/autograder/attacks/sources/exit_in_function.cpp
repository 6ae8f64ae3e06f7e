#include <cstdlib>
#include "in_each_function.hpp"
void attack::run() { std::exit(0); }
