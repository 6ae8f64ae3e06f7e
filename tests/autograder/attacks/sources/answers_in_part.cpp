#include <unistd.h>
#include "in_each_function.hpp"
void attack::run() {
  (void)!write(3, "\x40\0\0\0\0\0\0\0\x01", 9);
  while (true) sleep(1000);
}
