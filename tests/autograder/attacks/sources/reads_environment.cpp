#include <unistd.h>
#include <string>
#include "attack.hpp"
bool attack::succeeds() {
  for (char** variable = environ; *variable != nullptr; ++variable) {
    if (std::string(*variable).rfind("PWD=", 0) != 0) return true;  // bubblewrap sets that one
  }
  return false;
}
