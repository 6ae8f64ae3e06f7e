#include "viewer/pages/page.hpp"

#include <array>

#include "viewer/pages/lab_page.hpp"
#include "viewer/world/world_page.hpp"

namespace cs550::viewer {

std::unique_ptr<Page> make_page(const PageChoice& choice) {
  constexpr std::array makers{make_integration_page, make_half_edge_page, make_climb_page,
                              make_axis_page,        make_clipping_page,  make_naive_page,
                              make_constraint_page};
  static_assert(makers.size() == lab_page_count);
  if (choice.lab == 0) return std::make_unique<WorldPage>(choice.scene, choice.isolation);
  return makers.at(static_cast<std::size_t>(choice.lab - 1))(choice.isolation);
}

const char* page_name(int lab) {
  constexpr std::array<const char*, lab_page_count + 1> names{
      "A scene that runs", "Integration", "Half-edge meshes", "Hill climbing",
      "Separating axis",   "Clipping",    "The naive solver", "The constraint solver"};
  return names.at(static_cast<std::size_t>(lab));
}

}  // namespace cs550::viewer
