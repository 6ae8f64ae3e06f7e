// What the browser does not have: the hull library is native code, and emscripten's C++ library
// reads no floating-point numbers by std::from_chars. Scenes that need either are refused with
// these sentences.
#include "cs550/primitives.hpp"
#include "engine/shapes/obj_check.hpp"

namespace cs550 {

SoupResult convex_hull(std::span<const Vec3> /*points*/) {
  return {{}, "hulls of point clouds are not available in the browser; use ./cs550 view"};
}

std::string first_obj_fault(std::istream& /*text*/) {
  return "OBJ files are not available in the browser; use ./cs550 view";
}

}  // namespace cs550
