#include <fstream>
#include "attack.hpp"
bool attack::succeeds() {
  return std::ifstream("@ROOT@/solutions/lab3_hill_climbing/hill_climbing.cpp").good();
}
