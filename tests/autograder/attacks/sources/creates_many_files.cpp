#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>

#include "attack.hpp"
bool attack::succeeds() {
  bool made = false;
  for (int i = 0; i < 100'000; ++i) {
    const std::string name = "cs550_attack" + std::to_string(i);
    made = made || mkdir(name.c_str(), 0700) == 0 || symlink("/", name.c_str()) == 0 ||
           open(name.c_str(), O_CREAT | O_WRONLY, 0600) >= 0;
  }
  return made;
}
