#include "engine/pairs/query_prefetch.hpp"

#include <bitset>
#include <cstdint>
#include <vector>

#include "engine/prefetch.hpp"

namespace cs550 {

namespace {

template <class Element>
void prefetch_elements(const std::vector<Element>& elements) {
  // A query reads little of a longer array.
  constexpr std::size_t longest = 4096;
  const std::size_t size = elements.size() * sizeof(Element);
  if (size <= longest) prefetch(elements.data(), size);
}

/// Calls `visit(shape)` for the bodies of the pairs. Pairs are sorted by their first body, so its shape is passed once.
template <class Visit>
void for_shapes(const WorldState& world, std::span<const PairQuery> queries, const Visit& visit) {
  const ConvexShape* last = nullptr;
  for (const PairQuery& query : queries) {
    const PairSummary& pair = world.pairs.summaries[query.pair];
    const ConvexShape* const a = world.definitions[pair.body_a].shape.get();
    const ConvexShape* const b = world.definitions[pair.body_b].shape.get();
    if (a != last) visit(*a);
    if (b != a) visit(*b);
    last = a;
  }
}

/// About how many shapes the bodies have: two of them may count as one. An exact count would take longer than it saves.
std::size_t count_shapes(std::span<const BodyDef> bodies) {
  constexpr int bits = 15;
  std::bitset<1 << bits> seen;
  for (const BodyDef& body : bodies) {
    // Spreads addresses that are a multiple of some size apart.
    const std::uint64_t hash =
        reinterpret_cast<std::uintptr_t>(body.shape.get()) * 0x9E3779B97F4A7C15;
    seen.set(hash >> (64 - bits));
  }
  return seen.count();
}

}  // namespace

bool pays_to_prefetch(const WorldState& world) {
  constexpr std::size_t many_shapes = 700;  // of 32 vertices: 4 MB
  return world.definitions.size() > many_shapes && count_shapes(world.definitions) > many_shapes;
}

void prefetch_meshes(const WorldState& world, std::span<const PairQuery> queries) {
  for (const PairQuery& query : queries) {
    const PairSummary& pair = world.pairs.summaries[query.pair];
    prefetch(&world.definitions[pair.body_a].shape, sizeof(ShapePtr));
    prefetch(&world.definitions[pair.body_b].shape, sizeof(ShapePtr));
    prefetch(&world.pairs.axes[query.pair], sizeof(SeparatingAxis));
    if (pair.points > 0) prefetch(&world.pairs.contacts[query.pair], sizeof(Contact));
  }
  for_shapes(world, queries, [](const ConvexShape& shape) { prefetch(&shape, sizeof shape); });
  for_shapes(world, queries, [](const ConvexShape& shape) {
    prefetch_elements(shape.mesh.vertices);
    prefetch_elements(shape.mesh.vertex_edge);
    prefetch_elements(shape.mesh.edges);
    prefetch_elements(shape.mesh.faces);
    prefetch_elements(shape.plane_blocks);
  });
}

}  // namespace cs550
