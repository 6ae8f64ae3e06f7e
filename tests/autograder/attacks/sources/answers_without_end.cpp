#include <unistd.h>
#include "in_each_function.hpp"
void attack::run() {
  const char huge[] = "\0\0\0\0\0\0\0\x10";
  (void)!write(3, huge, 8);
  while (write(3, huge, 8) == 8) {
  }
}
