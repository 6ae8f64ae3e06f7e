#include <sys/socket.h>
#include "attack.hpp"
bool attack::succeeds() {
  return socket(AF_INET, SOCK_STREAM, 0) >= 0 || socket(AF_UNIX, SOCK_STREAM, 0) >= 0;
}
