#include <unistd.h>
#include "attack.hpp"
bool attack::succeeds() {
  const int child = fork();
  if (child == 0) _exit(0);
  return child > 0;
}
