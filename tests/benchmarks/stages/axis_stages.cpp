/// Queries of lab 4: overlapping hulls, separated hulls, and the worst case of the edge query.
#include <memory>

#include "benchmarks/stages/hull_pairs.hpp"
#include "benchmarks/stages/stage.hpp"
#include "cs550/primitives.hpp"

namespace cs550::bench {
namespace {

void find_axes(benchmark::State& state, const HullPairs& hulls, bool with_hint) {
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    const HullPair& pair = hulls.pairs[next++ % hulls.pairs.size()];
    benchmark::DoNotOptimize(find_separating_axis(
        pair.a, pair.b, with_hint ? pair.hint : SeparatingAxis{}, HullPairs::margin));
  }
}

/// Two n-gon prisms at a right angle. Each long edge of one crosses half of the long edges of the
/// other.
void query_edges_of_crossed_prisms(benchmark::State& state, int sides) {
  const TriangleSoup soup = prism_soup(sides, 1, 2);
  const ShapePtr prism = make_shape(soup.vertices, soup.triangles).shape;
  const Quat quarter(Eigen::AngleAxis<Real>(pi / 2, Vec3(1, Real(0.01), 0).normalized()));
  const PosedShape a{prism.get(), {Vec3::Zero(), Quat::Identity()}};
  const PosedShape b{prism.get(), {Vec3(Real(1.9), 0, 0), quarter}};
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(query_edge_directions(a, b));
}

}  // namespace

std::vector<Stage> axis_stages() {
  std::vector<Stage> stages;
  const auto add = [&](const std::string& family, int n, auto run) {
    stages.push_back({member(family, n), static_cast<double>(n), 1, std::move(run)});
  };
  constexpr Real margin = HullPairs::margin;
  const std::vector<int> sizes = doubled(8, 256);
  for (const int n : sizes) {
    add("axis/overlap", n,
        [n](auto& state) { find_axes(state, HullPairs(n, Real(-0.1), 0), false); });
  }
  for (const int n : sizes) {
    add("axis/overlap_hint", n,
        [n](auto& state) { find_axes(state, HullPairs(n, Real(-0.1), 0), true); });
  }
  for (const int n : sizes) {
    add("axis/apart_hint", n,
        [n](auto& state) { find_axes(state, HullPairs(n, margin, 1), true); });
  }
  for (const int n : doubled(8, 64)) {
    add("axis/crossed_prisms", n, [n](auto& state) { query_edges_of_crossed_prisms(state, n); });
  }
  return stages;
}

}  // namespace cs550::bench
