#include <unistd.h>
#include <fstream>
#include <string>
#include "attack.hpp"
bool attack::succeeds() {
  for (const int process : {1, static_cast<int>(getppid())}) {
    std::string word;
    if (std::ifstream("/proc/" + std::to_string(process) + "/environ") >> word) return true;
    if (std::ifstream("/proc/" + std::to_string(process) + "/maps") >> word) return true;
  }
  return false;
}
