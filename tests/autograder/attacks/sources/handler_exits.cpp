#include <unistd.h>
#include <csignal>
#include "in_each_function.hpp"
void attack::run() {
  std::signal(SIGSEGV, [](int) { _exit(0); });
  std::raise(SIGSEGV);
}
