#include <fstream>
#include <string>
#include "attack.hpp"
bool attack::succeeds() {
  for (const char* folder : {"/tmp/", "/dev/shm/", "/var/tmp/", "./", "@ROOT@/"}) {
    if (std::ofstream(std::string(folder) + "cs550_attack") << std::string(1 << 20, 'x'))
      return true;
  }
  return false;
}
