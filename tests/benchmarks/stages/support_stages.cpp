/// Support functions of lab 3 on random hulls: all vertices, a climb from a fixed vertex, and a climb
/// from the answer for a direction 0.05 rad away.
#include <memory>

#include "benchmarks/stages/stage.hpp"
#include "cs550/hill_climbing.hpp"
#include "cs550/primitives.hpp"
#include "helpers/random.hpp"

namespace cs550::bench {
namespace {

struct Query {
  Vec3 direction;
  Index start;  ///< of a climb
};

struct SupportQueries {
  HalfEdgeMesh mesh;
  std::vector<Query> queries;
};

enum class Start { Fixed, Near };

SupportQueries support_queries(int vertices, Start start) {
  constexpr int count = 256;
  constexpr Real angle = Real(0.05);
  const TriangleSoup soup = convex_hull(random_sphere_points(vertices, 3)).soup;
  SupportQueries result{build_half_edge_mesh(soup.vertices, soup.triangles).mesh, {}};
  test::Random random(6);
  while (result.queries.size() < count) {
    const Vec3 direction = random.unit_vector();
    const Vec3 before = (direction + angle * random.unit_vector()).normalized();
    const Index near = support_brute_force(result.mesh.vertices, before).vertex;
    result.queries.push_back({direction, start == Start::Near ? near : 0});
  }
  return result;
}

template <class Find>
void find_supports(benchmark::State& state, const SupportQueries& input, const Find& find) {
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(find(input.mesh, input.queries[next++ % input.queries.size()]));
  }
}

void compare_all(benchmark::State& state, int n) {
  find_supports(state, support_queries(n, Start::Fixed),
                [](const HalfEdgeMesh& mesh, const Query& query) {
                  return support_brute_force(mesh.vertices, query.direction);
                });
}

void climb(benchmark::State& state, int n, Start start) {
  find_supports(state, support_queries(n, start), [](const HalfEdgeMesh& mesh, const Query& query) {
    return hill_climb(mesh, query.direction, query.start);
  });
}

}  // namespace

std::vector<Stage> support_stages() {
  std::vector<Stage> stages;
  const auto add = [&](const std::string& family, int n, auto run) {
    stages.push_back({member(family, n), static_cast<double>(n), 1, std::move(run)});
  };
  const std::vector<int> sizes = doubled(8, 8192);
  for (const int n : sizes) add("support/all", n, [n](auto& state) { compare_all(state, n); });
  for (const int n : sizes)
    add("support/climb", n, [n](auto& state) { climb(state, n, Start::Fixed); });
  for (const int n : sizes)
    add("support/climb_near", n, [n](auto& state) { climb(state, n, Start::Near); });
  return stages;
}

}  // namespace cs550::bench
