#include "viewer/pages/page.hpp"

#include <array>

#include "viewer/world/world_page.hpp"

namespace cs550::viewer {

std::unique_ptr<Page> make_page(const PageChoice& choice) {
  return std::make_unique<WorldPage>(choice.scene, choice.isolation);
}

const char* page_name(int lab) {
  constexpr std::array<const char*, lab_page_count + 1> names{
      "A scene that runs", "Integration", "Half-edge meshes", "Hill climbing",
      "Separating axis",   "Clipping",    "The naive solver", "The constraint solver"};
  return names.at(static_cast<std::size_t>(lab));
}

}  // namespace cs550::viewer
