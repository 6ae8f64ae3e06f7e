#include <fcntl.h>
#include <sys/mman.h>
#include <sys/shm.h>
#include <unistd.h>

#include "attack.hpp"
// What one test leaves there, the next one could read.
bool attack::succeeds() {
  return shmget(550, 4096, IPC_CREAT | 0600) >= 0 || memfd_create("cs550_attack", 0) >= 0 ||
         shm_open("/cs550_attack", O_CREAT | O_RDWR, 0600) >= 0;
}
