#include "in_each_function.hpp"
namespace {
int deeper(volatile int* above) {
  volatile int here[256] = {*above};
  return deeper(here) + here[0];
}
}  // namespace
void attack::run() { volatile int start = deeper(&start); }
