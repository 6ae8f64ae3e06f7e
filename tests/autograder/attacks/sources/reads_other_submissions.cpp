#include <fcntl.h>

#include "attack.hpp"
bool attack::succeeds() {
  for (const char* file : {"../../submission/attack.hpp", "../../submission", "..", "/tmp",
                           "../judge.json", "@ROOT@/tests/autograder/attacks/sources/attack.hpp"}) {
    const int found = open(file, O_RDONLY);
    char byte = 0;
    if (found >= 0 && pread(found, &byte, 1, 0) == 1) return true;
  }
  return false;
}
