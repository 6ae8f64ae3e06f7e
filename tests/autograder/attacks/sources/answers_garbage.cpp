#include <unistd.h>
#include "in_each_function.hpp"
void attack::run() { (void)!write(3, "\x05\0\0\0\0\0\0\0\xff\xfe\xfd\xfc\xfb", 13); }
