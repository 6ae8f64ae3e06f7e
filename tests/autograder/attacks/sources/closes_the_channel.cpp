#include <unistd.h>
#include "in_each_function.hpp"
void attack::run() { close(3); }
