#include <dlfcn.h>
#include "attack.hpp"
bool attack::succeeds() {
  return dlopen("@ROOT@/build/test/labs/liblab3_reference.so", RTLD_NOW) != nullptr;
}
