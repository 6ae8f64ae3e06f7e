#include "cs550/not_implemented.hpp"
#include "in_each_function.hpp"
void attack::run() { throw cs550::NotImplemented("Lx\x1b[31m", "f", "g", 1); }
