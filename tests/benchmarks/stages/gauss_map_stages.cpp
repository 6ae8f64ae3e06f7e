/// The test of lab 4 whether two arcs cross.
#include <array>

#include "benchmarks/stages/stage.hpp"
#include "cs550/separating_axis.hpp"
#include "helpers/random.hpp"

namespace cs550::bench {
namespace {

void test_arcs(benchmark::State& state) {
  std::vector<std::array<Vec3, 4>> arcs(256);
  test::Random random(8);
  for (std::array<Vec3, 4>& normals : arcs) {
    for (Vec3& normal : normals) normal = random.unit_vector();
  }
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    const auto& [a, b, c, d] = arcs[next++ % arcs.size()];
    benchmark::DoNotOptimize(is_minkowski_face(a, b, c, d));
  }
}

}  // namespace

std::vector<Stage> gauss_map_stages() { return {{"gauss_map/arcs", 0, 1, test_arcs}}; }

}  // namespace cs550::bench
