#include <dlfcn.h>
#include <string_view>
#include "attack.hpp"
namespace {
/// The starter is found as well: it answers for functions that are missing, with "not implemented".
bool is_the_reference(void* found) {
  Dl_info library;
  if (found == nullptr || found == reinterpret_cast<void*>(&cs550::hill_climb)) return false;
  return dladdr(found, &library) == 0 ||
         std::string_view(library.dli_fname).find("/liblab3_stub.so") == std::string_view::npos;
}
}  // namespace
bool attack::succeeds() {
  const char* symbol =
      "_ZN5cs55010hill_climbERKNS_"
      "12HalfEdgeMeshERKN5Eigen6MatrixIfLi3ELi1ELi2ELi3ELi1EEEiPSt6vectorIiSaIiEE";
  return is_the_reference(dlsym(RTLD_DEFAULT, symbol)) ||
         is_the_reference(dlsym(RTLD_NEXT, symbol));
}
