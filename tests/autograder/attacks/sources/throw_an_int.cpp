#include "in_each_function.hpp"
void attack::run() { throw 7; }
