#include <unistd.h>
#include "in_each_function.hpp"
void attack::run() {
  const char forged[] = "\x09\0\0\0\0\0\0\0\x01\0\0\0\0\x01\0\0\0";
  for (int i = 0; i < 3; ++i) (void)!write(3, forged, sizeof forged - 1);
}
