#include <sys/stat.h>
#include "attack.hpp"
bool attack::succeeds() {
  struct stat file {};
  for (int descriptor = 4; descriptor < 1024; ++descriptor) {
    if (fstat(descriptor, &file) == 0) return true;
  }
  return false;
}
