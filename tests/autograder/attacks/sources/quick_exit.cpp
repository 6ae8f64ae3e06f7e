#include <cstdlib>
#include "in_each_function.hpp"
void attack::run() { std::quick_exit(0); }
