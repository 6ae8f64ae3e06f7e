// Queries of lab 4: overlapping hulls, separated hulls, and the worst case of the edge query. There
// is one executable for the fast kernel and one for the teaching form.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <vector>

#include "cs550/primitives.hpp"
#include "cs550/separating_axis.hpp"
#include "helpers/random.hpp"

namespace cs550::test {
namespace {

struct Pair {
  PosedShape a;
  PosedShape b;
  SeparatingAxis hint;
};

ShapePtr shape_of(const TriangleSoup& soup) {
  return make_shape(soup.vertices, soup.triangles).shape;
}

/// Hulls with random orientations, moved along a random direction until their separation is in a
/// given interval.
class HullPairs {
 public:
  HullPairs(int vertices, Real least, Real most) {
    for (std::uint32_t seed = 1; seed <= 8; ++seed) {
      shapes_.push_back(shape_of(convex_hull(random_sphere_points(vertices, seed)).soup));
    }
    Random random(4);
    while (pairs.size() < 64) {
      Pair pair;
      pair.a = {random_shape(random), {Vec3::Zero(), random.orientation()}};
      pair.b = {random_shape(random), {Vec3::Zero(), random.orientation()}};
      const Real distance = random.real(1, 3);
      pair.b.pose.position = distance * random.unit_vector();
      pair.hint = find_separating_axis(pair.a, pair.b, {}, margin);
      if (pair.hint.separation > least && pair.hint.separation < most) pairs.push_back(pair);
    }
  }

  static constexpr Real margin = Real(0.02);
  std::vector<Pair> pairs;

 private:
  const ConvexShape* random_shape(Random& random) const {
    return shapes_[random.integer(0, 7)].get();
  }

  std::vector<ShapePtr> shapes_;
};

void find_axes(benchmark::State& state, const HullPairs& hulls, bool with_hint) {
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    const Pair& pair = hulls.pairs[next++ % hulls.pairs.size()];
    benchmark::DoNotOptimize(find_separating_axis(
        pair.a, pair.b, with_hint ? pair.hint : SeparatingAxis{}, HullPairs::margin));
  }
}

void overlapping_hulls(benchmark::State& state) {
  find_axes(state, HullPairs(static_cast<int>(state.range(0)), Real(-0.1), 0), false);
}
BENCHMARK(overlapping_hulls)->RangeMultiplier(2)->Range(8, 256);

void overlapping_hulls_with_hint(benchmark::State& state) {
  find_axes(state, HullPairs(static_cast<int>(state.range(0)), Real(-0.1), 0), true);
}
BENCHMARK(overlapping_hulls_with_hint)->RangeMultiplier(2)->Range(8, 256);

void separated_hulls_with_hint(benchmark::State& state) {
  find_axes(state, HullPairs(static_cast<int>(state.range(0)), HullPairs::margin, 1), true);
}
BENCHMARK(separated_hulls_with_hint)->RangeMultiplier(2)->Range(8, 256);

/// The number of arcs of A that cross arcs of −B.
int count_crossings(const PosedShape& a, const PosedShape& b) {
  const auto normal = [](const PosedShape& body, Index e) {
    return body.plane(body.mesh().edge(e).face).normal;
  };
  int crossings = 0;
  for (Index e_a = 0; e_a < a.mesh().edge_count(); e_a += 2) {
    for (Index e_b = 0; e_b < b.mesh().edge_count(); e_b += 2) {
      if (is_minkowski_face(normal(a, e_a), normal(a, e_a ^ 1), -normal(b, e_b),
                            -normal(b, e_b ^ 1))) {
        ++crossings;
      }
    }
  }
  return crossings;
}

/// Two n-gon prisms at a right angle. Each long edge of one crosses half of the long edges of the
/// other.
void edges_of_crossed_prisms(benchmark::State& state) {
  const int sides = static_cast<int>(state.range(0));
  const ShapePtr prism = shape_of(prism_soup(sides, 1, 2));
  const Quat quarter(Eigen::AngleAxis<Real>(pi / 2, Vec3(1, Real(0.01), 0).normalized()));
  const PosedShape a{prism.get(), {Vec3::Zero(), Quat::Identity()}};
  const PosedShape b{prism.get(), {Vec3(Real(1.9), 0, 0), quarter}};
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(query_edge_directions(a, b));
  }
  state.counters["crossings"] = count_crossings(a, b);
}
BENCHMARK(edges_of_crossed_prisms)->RangeMultiplier(2)->Range(8, 64);

}  // namespace
}  // namespace cs550::test
