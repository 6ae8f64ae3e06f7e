#include <algorithm>
#include <mutex>
#include <optional>

#include "cs550/clipping.hpp"
#include "cs550/static_vector.hpp"
#include "engine/contacts/loaded_points.hpp"
#include "engine/pairs/feature_retest.hpp"
#include "engine/pairs/near_pairs.hpp"
#include "engine/pairs/query_prefetch.hpp"
#include "engine/pairs/temporal_coherence.hpp"
#include "engine/world/stages.hpp"

namespace cs550 {

namespace {

/// Pairs that a thread takes at a time. Their costs differ a lot.
constexpr Index few_pairs = 8;

/// Calls `visit(first, last)` for a few pairs at a time, by several threads if there are any: what a pair needs and
/// leaves belongs to no other.
template <class Visit>
void for_few_pairs(WorldState& world, const Visit& visit) {
  for_blocks(world.team, world.pairs.size(), few_pairs, [&](std::size_t first, std::size_t last) {
    const auto end = static_cast<Index>(last);
    for (auto pair = static_cast<Index>(first); pair < end; pair += few_pairs) {
      visit(pair, std::min(pair + few_pairs, end));
    }
  });
}

bool is_on(const ConvexShape& shape, const Vec3& anchor) {
  constexpr Real rounding = Real(1.01);
  return anchor.norm() <= rounding * shape.radius;
}

/// Bodies that move by more than their length in a step have contacts across gaps of that size. There an edge
/// that is prolonged beyond its ends, or rounding, may put points beside a body. Their levers would be a
/// thousand times the body's length, and the effective masses beyond float.
void drop_points_beside(const ConvexShape& a, const ConvexShape& b, Manifold& manifold) {
  const auto points = manifold.points;
  manifold.points.clear();
  for (const ContactPoint& point : points) {
    if (is_on(a, point.anchor_a) && is_on(b, point.anchor_b)) manifold.points.push_back(point);
  }
}

/// @param now takes over the impulses of the last manifold, and those of its points that still carry load
void replace_manifold(WorldState& world, std::size_t pair, Real separation, Manifold& now, Real h) {
  Contact& contact = world.pairs.contacts[pair];
  const ConvexShape& a = *world.definitions[contact.body_a].shape;
  const ConvexShape& b = *world.definitions[contact.body_b].shape;
  if (separation > std::min(a.radius, b.radius)) drop_points_beside(a, b, now);
  if (world.settings.warm_starting) {
    const Real reach = h * closing_speed(world, contact.body_a, contact.body_b);
    keep_loaded_points(world.posed_shape(contact.body_a), world.posed_shape(contact.body_b),
                       contact.manifold, reach, now);
    carry_impulses(contact.manifold, now);
  }
  contact.manifold = now;
  world.pairs.summarise(pair);
}

/// Most pairs have no points, and their contacts are not read.
void clear_manifold(WorldState& world, std::size_t pair) {
  if (!world.pairs.has_points(pair)) return;
  world.pairs.contacts[pair].manifold.points.clear();
  world.pairs.summarise(pair);
}

/// The query of a pair, unless its bounds are apart or its last answer still holds.
std::optional<PairQuery> query_of(WorldState& world, Index pair, Real h) {
  PairList& pairs = world.pairs;
  pairs.answers[pair] = PairAnswer::Queried;
  const Index body_a = pairs.summaries[pair].body_a;
  const Index body_b = pairs.summaries[pair].body_b;
  if (!world.slots[body_a].swept_bounds.overlaps(world.slots[body_b].swept_bounds)) {
    pairs.axes[pair].feature = AxisFeature::None;
    return {};
  }
  const Real margin = contact_margin(world, body_a, body_b, h);
  if (world.settings.temporal_coherence && answer_holds(world, pair, margin)) {
    pairs.answers[pair] = PairAnswer::Kept;
    return {};
  }
  return PairQuery{pair, margin};
}

void find_axis(WorldState& world, const PairQuery& query, Real h) {
  const auto [pair, margin] = query;
  PairList& pairs = world.pairs;
  RetestedFeatures now;
  if (world.settings.temporal_coherence && retest_features(world, pair, margin, now)) {
    pairs.answers[pair] = PairAnswer::Retested;
    pairs.axes[pair] = now.axis;
    replace_manifold(world, pair, now.axis.separation, now.manifold, h);
    remember_query(world, pair, margin);
    return remember_plane(world, pair);
  }
  const PosedShape a = world.posed_shape(pairs.summaries[pair].body_a);
  const PosedShape b = world.posed_shape(pairs.summaries[pair].body_b);
  pairs.axes[pair] = find_separating_axis(a, b, pairs.axes[pair], margin);
  remember_query(world, pair, margin);
}

void find_axes(WorldState& world, Real h) {
  const bool prefetch = pays_to_prefetch(world);
  for_few_pairs(world, [&](Index first, Index last) {
    StaticVector<PairQuery, few_pairs> queries;
    for (Index pair = first; pair < last; ++pair) {
      if (const auto query = query_of(world, pair, h)) queries.push_back(*query);
    }
    if (prefetch) prefetch_meshes(world, {queries.begin(), queries.end()});
    for (const PairQuery& query : queries) find_axis(world, query, h);
  });
}

/// The manifold of a full query.
void rebuild_manifold(WorldState& world, std::size_t pair, Real h) {
  const SeparatingAxis& axis = world.pairs.axes[pair];
  const bool bounds_are_apart = axis.feature == AxisFeature::None;
  if (bounds_are_apart) return clear_manifold(world, pair);
  const Index body_a = world.pairs.summaries[pair].body_a;
  const Index body_b = world.pairs.summaries[pair].body_b;
  const Real margin = contact_margin(world, body_a, body_b, h);
  if (axis.separation > margin) {
    clear_manifold(world, pair);
  } else {
    Manifold now =
        build_manifold(world.posed_shape(body_a), world.posed_shape(body_b), axis, margin);
    replace_manifold(world, pair, axis.separation, now, h);
    remember_plane(world, pair);
  }
}

/// That of a retested pair is there already.
void update_manifold(WorldState& world, std::size_t pair, Real h) {
  const PairAnswer answer = world.pairs.answers[pair];
  if (answer == PairAnswer::Queried) return rebuild_manifold(world, pair, h);
  if (answer == PairAnswer::Retested || !world.pairs.has_points(pair)) return;
  move_manifold(world, pair);
  world.pairs.summarise(pair);
}

void build_manifolds(WorldState& world, Real h) {
  for_few_pairs(world, [&](Index first, Index last) {
    for (Index pair = first; pair < last; ++pair) update_manifold(world, pair, h);
  });
}

/// The statistics of pairs from `first` to `last` − 1.
StepStats count_contacts(const PairList& pairs, std::size_t first, std::size_t last) {
  StepStats stats;
  for (std::size_t i = first; i < last; ++i) {
    const PairSummary& summary = pairs.summaries[i];
    stats.kept += static_cast<int>(pairs.answers[i] == PairAnswer::Kept);
    stats.retested += static_cast<int>(pairs.answers[i] == PairAnswer::Retested);
    stats.contacts += static_cast<int>(summary.points > 0);
    stats.points += summary.points;
    stats.deepest_separation = std::min(stats.deepest_separation, -summary.depth);
  }
  return stats;
}

void count_contacts(WorldState& world) {
  StepStats& stats = world.stats;
  stats.pairs = static_cast<int>(world.pairs.size());
  std::mutex mutex;
  for_pair_blocks(world, [&](std::size_t first, std::size_t last) {
    const StepStats some = count_contacts(world.pairs, first, last);
    const std::lock_guard lock(mutex);
    stats.kept += some.kept;
    stats.retested += some.retested;
    stats.contacts += some.contacts;
    stats.points += some.points;
    stats.deepest_separation = std::min(stats.deepest_separation, some.deepest_separation);
  });
}

}  // namespace

void detect_collisions(WorldState& world, Real h) {
  run_stage(world, Stage::BroadPhase, update_pairs, h);
  run_stage(world, Stage::Collide, find_axes, h);
  if (world.settings.check_stages) {
    check_axes(world);
    run_stage(world, Stage::Collide, check_kept_answers, h);
  }
  // Without all axes there are no manifolds.
  if (!world.unwritten.contains(Stage::Collide)) {
    run_stage(world, Stage::Manifolds, build_manifolds, h);
  }
  if (world.settings.check_stages) check_manifolds(world);
  count_contacts(world);
}

}  // namespace cs550
