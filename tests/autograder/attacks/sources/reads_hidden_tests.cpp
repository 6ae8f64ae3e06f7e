#include <fstream>
#include "attack.hpp"
bool attack::succeeds() {
  return std::ifstream("@ROOT@/tests/lab3_hill_climbing/hidden/scaled_test.cpp").good();
}
