#include "pages/make_page.hpp"

#include <array>

#include "cs550/scene.hpp"
#include "isolation/service.hpp"
#include "pages/failure/failure_page.hpp"
#include "pages/labs/lab_page.hpp"
#include "pages/world/world_page.hpp"

namespace cs550::pages {

std::unique_ptr<Page> make_page(const PageChoice& choice) {
  constexpr std::array makers{make_integration_page, make_half_edge_page, make_climb_page,
                              make_axis_page,        make_clipping_page,  make_naive_page,
                              make_constraint_page};
  static_assert(makers.size() == lab_page_count);
  if (choice.lab == 0) return std::make_unique<WorldPage>(choice.scene, choice.isolation);
  if (choice.lab == failure_page) return make_failure_page(choice.picture);
  return makers.at(choice.lab - 1)(choice.isolation);
}

std::string fault_of_scene(const PageChoice& choice) {
  const auto read = [](const std::string& scene) {
    const SceneResult found = find_scene(scene);
    return found.missing_step.empty() ? found.error : std::string();
  };
  isolation::Service<std::string, std::string> reader(read, choice.isolation);
  return reader.ask(choice.scene).value;
}

}  // namespace cs550::pages
