#include <sys/ptrace.h>
#include <unistd.h>
#include "attack.hpp"
bool attack::succeeds() { return ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr) == 0; }
