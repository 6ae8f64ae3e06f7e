#include <dlfcn.h>
#include "attack.hpp"
bool attack::succeeds() {
  void* mine = reinterpret_cast<void*>(&cs550::hill_climb);
  const char* symbol =
      "_ZN5cs55010hill_climbERKNS_"
      "12HalfEdgeMeshERKN5Eigen6MatrixIfLi3ELi1ELi2ELi3ELi1EEEiPSt6vectorIiSaIiEE";
  void* found = dlsym(RTLD_DEFAULT, symbol);
  void* next = dlsym(RTLD_NEXT, symbol);
  return (found != nullptr && found != mine) || (next != nullptr && next != mine);
}
