#include <csignal>
#include "in_each_function.hpp"
void attack::run() { std::raise(SIGKILL); }
