#include "cs550/world.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/islands/sleeping.hpp"
#include "engine/pairs/near_pairs.hpp"
#include "engine/world/new_body.hpp"
#include "engine/world/settings_ranges.hpp"
#include "engine/world/stages.hpp"

namespace cs550 {

namespace {

/// The index of a body that is alive.
std::size_t living(const World& world, BodyId id) {
  if (world.is_alive(id)) return static_cast<std::size_t>(id.index);
  throw std::invalid_argument(
      "no body of this world has the index " + std::to_string(id.index) + " and the generation " +
      std::to_string(id.generation) +
      ": it has been removed, or the id is of another world; check is_alive() first");
}

/// The lowest free index, so that the same calls give the same order of bodies.
std::size_t take_free_place(WorldState& world) {
  std::size_t place = world.first_free;
  while (place < world.slot_count() && world.slots[place].alive) ++place;
  world.first_free = place + 1;
  return place;
}

/// Ends the contacts of bodies, and removes their leaves.
/// @param bodies each once
void take_out(WorldState& world, std::span<const Index> bodies) {
  world.leaving.assign(world.slot_count(), 0);
  for (const Index body : bodies) world.leaving[body] = 1;
  wake_around(world, world.leaving);
  remove_pairs_of(world, world.leaving);
  for (const Index body : bodies) world.tree.remove(world.slots[body].leaf);
}

/// Leaves an empty slot in the place of a body that has been taken out.
void empty_slot(WorldState& world, Index body) {
  world.slots[body] = {world.slots[body].generation, false, no_index, {}};
  world.bodies[body] = make_immovable_body(BodyKind::Static, {});
  world.definitions[body] = {};
  world.first_free = std::min(world.first_free, static_cast<std::size_t>(body));
  --world.alive_count;
}

void share_step(WorldState& world, int threads, Real h) {
  ThreadTeam team(threads);
  struct Assignment {
    ~Assignment() { state.team = nullptr; }
    WorldState& state;
  };
  const Assignment until_the_end{world};
  world.team = &team;
  team.run([&] { advance(world, h); });
}

/// Shares the step if that saves time.
void share_step_if_faster(WorldState& world, int threads, Real h) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  if (world.thread_trial.shares_next_step()) {
    share_step(world, threads, h);
  } else {
    advance(world, h);
  }
  world.thread_trial.note(std::chrono::duration<double>(Clock::now() - start).count());
}

}  // namespace

const char* to_string(Stage stage) {
  switch (stage) {
    case Stage::Integrate:
      return "integrate";
    case Stage::BroadPhase:
      return "broad phase";
    case Stage::Collide:
      return "collide";
    case Stage::Manifolds:
      return "manifolds";
    case Stage::Prepare:
      return "prepare";
    case Stage::Solve:
      return "solve";
  }
  return "";
}

World::World(const WorldSettings& settings) : state_(std::make_unique<WorldState>()) {
  state_->settings = settings;
}
World::World(const World& other) : state_(std::make_unique<WorldState>(*other.state_)) {}
World& World::operator=(const World& other) {
  if (state_ == nullptr) state_ = std::make_unique<WorldState>();  // it was moved from
  if (this != &other) *state_ = *other.state_;
  return *this;
}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

WorldSettings& World::settings() { return state_->settings; }
const WorldSettings& World::settings() const { return state_->settings; }

BodyId World::add_body(const BodyDef& def) {
  const RigidBody body = make_body(def);
  const std::size_t place = take_free_place(*state_);
  if (place == state_->slot_count()) {
    state_->bodies.emplace_back();
    state_->definitions.push_back(def);  // which may be that of another body of this world
    state_->slots.emplace_back();
  } else {
    state_->definitions[place] = def;
    ++state_->slots[place].generation;
  }
  state_->bodies[place] = body;
  state_->slots[place].alive = true;
  ++state_->alive_count;
  const auto index = static_cast<Index>(place);
  insert_leaf(*state_, index);
  return state_->id_at(index);
}

void World::remove_body(BodyId id) { remove_bodies(std::span(&id, 1)); }

void World::remove_bodies(std::span<const BodyId> ids) {
  std::vector<Index> bodies;
  for (const BodyId id : ids) {
    if (is_alive(id)) bodies.push_back(id.index);
  }
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  if (bodies.empty()) return;
  take_out(*state_, bodies);
  for (const Index body : bodies) empty_slot(*state_, body);
}

void World::redefine_body(BodyId id, const BodyDef& def) {
  const std::size_t place = living(*this, id);
  const RigidBody body = make_body(def);
  take_out(*state_, std::span(&id.index, 1));
  state_->bodies[place] = body;
  state_->definitions[place] = def;
  insert_leaf(*state_, id.index);
}

bool World::is_alive(BodyId id) const {
  return id.index >= 0 && id.index < static_cast<Index>(state_->slot_count()) &&
         state_->slots[id.index].alive && id == state_->id_at(id.index);
}

int World::body_count() const { return state_->alive_count; }
std::span<const RigidBody> World::bodies() const { return state_->bodies; }
BodyId World::id_at(Index index) const {
  if (index >= 0 && index < static_cast<Index>(state_->slot_count())) return state_->id_at(index);
  throw std::invalid_argument("World::id_at() needs an index of bodies(), which has " +
                              std::to_string(state_->slot_count()) + "; found " +
                              std::to_string(index));
}
const RigidBody& World::body(BodyId id) const { return state_->bodies[living(*this, id)]; }
RigidBody& World::body(BodyId id) { return state_->bodies[living(*this, id)]; }
const ShapePtr& World::shape(BodyId id) const { return definition(id).shape; }
const BodyDef& World::definition(BodyId id) const { return state_->definitions[living(*this, id)]; }
PosedShape World::posed_shape(BodyId id) const {
  return state_->posed_shape(static_cast<Index>(living(*this, id)));
}

void World::step(Real h) {
  constexpr Real shortest = Real(1e-30);  // the reciprocal of a shorter one may not be finite
  if (!std::isfinite(h) || h < shortest) {
    throw std::invalid_argument(
        "World::step() needs a finite number of seconds of at least 1e-30, such as 1/60; found " +
        std::to_string(h));
  }
  check(state_->settings);
  const int wanted = state_->settings.threads;
  const int threads = wanted == 1 ? 1 : useful_threads(wanted);
  if (threads == 1) return advance(*state_, h);
  if (!state_->settings.adaptive_threads) return share_step(*state_, threads, h);
  share_step_if_faster(*state_, threads, h);
}
std::int64_t World::step_count() const { return state_->step_count; }
double World::time() const { return state_->time; }

std::span<const Contact> World::contacts() const { return state_->pairs.contacts; }
std::span<const Contact> World::sleeping_contacts() const {
  return state_->sleeping.pairs.contacts;
}
std::span<const SeparatingAxis> World::axes() const { return state_->pairs.axes; }
std::span<const ContactEvent> World::began() const { return state_->began; }
std::span<const ContactEvent> World::ended() const { return state_->ended; }
const StepStats& World::stats() const { return state_->stats; }
std::span<const StageProblem> World::problems() const { return state_->problems; }
const AabbTree& World::broad_phase() const { return state_->tree; }

double World::momentum_error() const {
  const MomentumAudit& audit = state_->audit;
  return audit.largest_sum > 0 ? audit.unexplained.norm() / audit.largest_sum : 0;
}

}  // namespace cs550
