#include "in_each_function.hpp"
void attack::run() {
  for (volatile int i = 0;; i = i + 1) {
  }
}
