#include <cstdlib>
#include <thread>
#include "in_each_function.hpp"
void attack::run() {
  std::thread([] { std::exit(0); }).join();
}
