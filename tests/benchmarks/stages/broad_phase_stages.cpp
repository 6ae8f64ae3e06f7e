/// The tree of the broad phase: every box of a cubic grid moves, then asks for its neighbours.
#include <cmath>

#include "benchmarks/stages/stage.hpp"
#include "cs550/broad_phase.hpp"

namespace cs550::bench {
namespace {

/// @param across number of boxes along each axis; each box overlaps its six neighbours
void move_and_query(benchmark::State& state, int across) {
  constexpr Real half = Real(0.51);
  AabbTree tree;
  std::vector<Index> leaves;
  std::vector<Bounds> boxes;
  for (int i = 0; i < across * across * across; ++i) {
    const Vec3 centre(static_cast<Real>(i % across), static_cast<Real>(i / across % across),
                      static_cast<Real>(i / (across * across)));
    boxes.push_back({centre - Vec3::Constant(half), centre + Vec3::Constant(half)});
    leaves.push_back(tree.insert(boxes.back(), i));
  }
  std::vector<Index> found;
  Real shift = Real(0.01);
  for ([[maybe_unused]] auto _ : state) {
    shift = -shift;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      const Vec3 moved = Vec3::Constant(shift);
      tree.move(leaves[i], {boxes[i].lower + moved, boxes[i].upper + moved});
    }
    for (const Index leaf : leaves) {
      found.clear();
      tree.query(tree.bounds(leaf), found);
      benchmark::DoNotOptimize(found.data());
    }
  }
}

}  // namespace

std::vector<Stage> broad_phase_stages() {
  std::vector<Stage> stages;
  for (const int across : {5, 10, 20}) {
    const int n = across * across * across;
    stages.push_back({member("broad_phase/move_and_query", n), static_cast<double>(n),
                      static_cast<double>(n),
                      [across](auto& state) { move_and_query(state, across); }});
  }
  return stages;
}

}  // namespace cs550::bench
