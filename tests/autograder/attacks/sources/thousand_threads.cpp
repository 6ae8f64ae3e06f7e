#include <thread>
#include <vector>

#include "attack.hpp"
bool attack::succeeds() {
  for (int i = 0; i < 1000; ++i) {
    std::thread([] {
      for (;;) std::this_thread::yield();
    }).detach();
  }
  return true;
}
