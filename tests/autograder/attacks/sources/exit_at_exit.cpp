#include <unistd.h>
#include <cstdlib>
namespace {
const int registered = std::atexit([] { _exit(3); });
}
