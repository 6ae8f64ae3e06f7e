#include <dlfcn.h>

#include <string>

namespace cs550 {

bool called_by_given_code(void* caller);
bool called_by_given_code(void* caller) {
  Dl_info place;
  return dladdr(caller, &place) != 0 &&
         std::string(place.dli_fname).find("given") != std::string::npos;
}

}  // namespace cs550
