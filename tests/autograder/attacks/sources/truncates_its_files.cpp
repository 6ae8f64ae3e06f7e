#include <fcntl.h>

#include "attack.hpp"
bool attack::succeeds() {
  for (const char* file : {"lab3_submission.so", "/lab3_submission.so"}) {
    if (open(file, O_RDONLY | O_TRUNC) >= 0) return true;
  }
  return false;
}
