#include "pages/base/page.hpp"

#include <array>

namespace cs550::pages {

const char* page_name(int lab) {
  constexpr std::array<const char*, lab_page_count + 1> names{
      "Running scene",   "Integration", "Half-edge meshes", "Hill climbing",
      "Separating axis", "Clipping",    "Naive solver",     "Constraint solver"};
  return names.at(lab);
}

}  // namespace cs550::pages
