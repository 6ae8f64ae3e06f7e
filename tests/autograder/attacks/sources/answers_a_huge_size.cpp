#include <unistd.h>
#include "in_each_function.hpp"
void attack::run() {
  (void)!write(3, "\x12\0\0\0\0\0\0\0\x01\0\0\0\0\0\0\0\0\x01\xff\xff\xff\xff\xff\xff\xff\x7f", 26);
}
