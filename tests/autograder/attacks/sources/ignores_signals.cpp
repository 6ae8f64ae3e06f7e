#include <csignal>
#include <thread>
#include "in_each_function.hpp"
void attack::run() {
  for (int signal = 1; signal < 32; ++signal) std::signal(signal, SIG_IGN);
  while (true) std::this_thread::sleep_for(std::chrono::seconds(100));
}
