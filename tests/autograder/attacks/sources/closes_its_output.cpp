#include <unistd.h>
#include <cstdio>
namespace {
const int closed = close(0) + close(1) + close(2);
}
