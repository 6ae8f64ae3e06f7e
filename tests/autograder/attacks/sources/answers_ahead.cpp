#include <unistd.h>
namespace {
const char forged[] = "\x09\0\0\0\0\0\0\0\x01\0\0\0\0\x01\0\0\0";
const auto sent = write(3, forged, sizeof forged - 1);
}  // namespace
