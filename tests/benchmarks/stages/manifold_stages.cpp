/// Axis and manifold of a pair of overlapping hulls, labs 4 and 5: without a hint, with the answer
/// for the same pose as a hint, and with the answer for a pose that has since moved. Then pairs that
/// touch as they do in a scene, through temporal coherence: at rest, and moved.
#include "benchmarks/stages/hull_pairs.hpp"
#include "benchmarks/stages/stage.hpp"
#include "cs550/clipping.hpp"
#include "engine/pairs/feature_retest.hpp"
#include "engine/pairs/pair_list.hpp"

namespace cs550::bench {
namespace {

enum class Recall { Cold, Warm, Moved };

void build_manifolds(benchmark::State& state, int vertices, Recall recall) {
  HullPairs hulls(vertices, Real(-0.1), 0);
  if (recall == Recall::Moved) hulls.move();
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    const HullPair& pair = hulls.pairs[next++ % hulls.pairs.size()];
    const SeparatingAxis axis = find_separating_axis(
        pair.a, pair.b, recall == Recall::Cold ? SeparatingAxis{} : pair.hint, HullPairs::margin);
    benchmark::DoNotOptimize(build_manifold(pair.a, pair.b, axis, HullPairs::margin));
  }
}

/// A world that has just queried these pairs, and has two bodies for each of them.
WorldState world_of(const HullPairs& hulls) {
  WorldState world;
  const auto add_body = [&](const PosedShape& posed) {
    BodyDef definition;
    definition.shape = ShapePtr(ShapePtr(), posed.shape);  // owned by the pairs
    world.definitions.push_back(definition);
    world.bodies.emplace_back().pose = posed.pose;
    world.slots.emplace_back().radius = posed.shape->radius;
    return static_cast<Index>(world.bodies.size() - 1);
  };
  PairListEdit edit(world.pairs);
  for (const HullPair& pair : hulls.pairs) {
    const Index body_a = add_body(pair.a);
    edit.insert(0, pair_key(body_a, add_body(pair.b)));
  }
  edit.apply();
  for (std::size_t i = 0; i < hulls.pairs.size(); ++i) {
    const HullPair& pair = hulls.pairs[i];
    world.pairs.contacts[i].manifold = build_manifold(pair.a, pair.b, pair.hint, HullPairs::margin);
    world.pairs.summarise(i);
    world.pairs.axes[i] = pair.hint;
    remember_query(world, i, HullPairs::margin);
    remember_plane(world, i);
  }
  return world;
}

void keep_manifolds(benchmark::State& state, int vertices) {
  const HullPairs hulls(vertices, Real(-0.1), 0);
  WorldState world = world_of(hulls);
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    const std::size_t pair = next++ % hulls.pairs.size();
    benchmark::DoNotOptimize(answer_holds(world, pair, HullPairs::margin));
    move_manifold(world, pair);
    benchmark::DoNotOptimize(world.pairs.contacts[pair]);
  }
}

/// What a step does for pairs that have moved by more than an answer is kept.
void retest_manifolds(benchmark::State& state, int vertices) {
  constexpr Real deepest = Real(0.005);
  HullPairs hulls(vertices, -deepest, 0);
  WorldState world = world_of(hulls);
  hulls.move();
  for (std::size_t i = 0; i < hulls.pairs.size(); ++i) {
    world.bodies[world.pairs.contacts[i].body_b].pose = hulls.pairs[i].b.pose;
  }
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    const std::size_t i = next++ % hulls.pairs.size();
    RetestedFeatures now;
    if (retest_features(world, i, HullPairs::margin, now)) {
      benchmark::DoNotOptimize(now.manifold);
      continue;
    }
    const HullPair& pair = hulls.pairs[i];
    const SeparatingAxis axis = find_separating_axis(pair.a, pair.b, pair.hint, HullPairs::margin);
    benchmark::DoNotOptimize(build_manifold(pair.a, pair.b, axis, HullPairs::margin));
  }
}

}  // namespace

std::vector<Stage> manifold_stages() {
  std::vector<Stage> stages;
  const std::pair<const char*, Recall> families[] = {{"manifold/cold", Recall::Cold},
                                                     {"manifold/warm", Recall::Warm},
                                                     {"manifold/moved", Recall::Moved}};
  for (const auto& [family, recall] : families) {
    const auto run = [recall = recall](int vertices) {
      return [=](benchmark::State& state) { build_manifolds(state, vertices, recall); };
    };
    stages.push_back({std::string(family) + "/cubes", 0, 1, run(0)});
    for (const int n : doubled(8, 256))
      stages.push_back({member(family, n), static_cast<double>(n), 1, run(n)});
  }
  for (const int n : {8, 32, 128}) {
    stages.push_back({member("manifold/kept", n), static_cast<double>(n), 1,
                      [n](benchmark::State& state) { keep_manifolds(state, n); }});
  }
  for (const int n : {0, 8, 32, 128}) {
    stages.push_back({n == 0 ? "manifold/retested/cubes" : member("manifold/retested", n),
                      static_cast<double>(n), 1,
                      [n](benchmark::State& state) { retest_manifolds(state, n); }});
  }
  return stages;
}

}  // namespace cs550::bench
