// Prints the state hash of piles after some steps, and fails if it depends on the number of threads. The piles
// have so many contacts that they are solved in parts.
#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>

#include "engine/four_threads.hpp"
#include "engine/test_bodies.hpp"

namespace {

using cs550::World;

// Few, because with sanitizers a step takes long.
constexpr int steps = 24;
constexpr int most_steps_awake = 600;
constexpr int enough_contacts = 128;  // for two parts, see divide_bodies()
// Two use all parts; more than there are parts share the sweeps over bodies only.
constexpr std::array thread_counts = {2, 4};

/// A pile, and what happens to it before each step.
struct Case {
  std::string name;
  World world;
  std::function<void(World&, int step)> before_step = [](World&, int) {};
  cs550::Index visitor = cs550::no_index;  ///< a body that must touch another one at the end
};

bool touches(const World& world, cs550::Index body) {
  return std::ranges::any_of(world.contacts(), [&](const cs550::Contact& contact) {
    return (contact.body_a == body || contact.body_b == body) && !contact.manifold.points.empty();
  });
}

std::uint64_t hash_after(const Case& pile, int threads) {
  World world = pile.world;
  world.settings().threads = threads;
  world.settings().adaptive_threads = false;
  int most_contacts = 0;
  for (int step = 0; step < steps; ++step) {
    pile.before_step(world, step);
    world.step(cs550::test::step_length);
    most_contacts = std::max(most_contacts, world.stats().contacts);
  }
  if (most_contacts < enough_contacts) {
    throw std::runtime_error(pile.name + " has too few contacts for two parts");
  }
  if (pile.visitor != cs550::no_index && !touches(world, pile.visitor)) {
    throw std::runtime_error(pile.name + ": nothing has reached the pile");
  }
  if (world.settings().sleeping && world.stats().asleep == 0) {
    throw std::runtime_error(pile.name + " is awake");
  }
  return world.state_hash();
}

/// @returns whether any number of threads leaves the same state
bool compare(const Case& pile) {
  const std::uint64_t alone = hash_after(pile, 1);
  std::printf("%s: %016llx\n", pile.name.c_str(), static_cast<unsigned long long>(alone));
  bool same = true;
  cs550::test::with_four_threads([&] {
    for (const int threads : thread_counts) {
      if (hash_after(pile, threads) == alone) continue;
      std::printf("%s: another state with %d threads\n", pile.name.c_str(), threads);
      same = false;
    }
  });
  return same;
}

/// Layers of cubes, a little apart and turned, on a floor.
World cubes(cs550::Quality quality, cs550::Real restitution) {
  cs550::test::Random random(9);
  World world;
  cs550::set_quality(world.settings(), quality);
  world.add_body(cs550::test::floor_body());
  const cs550::ShapePtr cube = cs550::test::box_shape(cs550::Vec3::Constant(cs550::Real(0.5)));
  for (int i = 0; i < 4 * 4 * 3; ++i) {
    cs550::BodyDef def = cs550::test::body_at(
        cube, cs550::Vec3(cs550::Real(i % 4), cs550::Real(i / 4 % 4),
                          cs550::Real(i / 16) * cs550::Real(1.01) + cs550::Real(0.5)));
    const cs550::Real angle = random.real(0, cs550::Real(0.02));
    def.pose.orientation = cs550::Quat(Eigen::AngleAxis<cs550::Real>(angle, random.unit_vector()));
    def.restitution = restitution;
    world.add_body(def);
  }
  return world;
}

/// A plate above the floor that moves into the pile.
/// @returns its index
cs550::Index add_plate(World& world) {
  cs550::BodyDef plate =
      cs550::test::body_at(cs550::test::box_shape({cs550::Real(0.1), 8, 1}),
                           {-1, 3, cs550::Real(1.5)}, cs550::BodyKind::Kinematic);
  plate.linear_velocity = {2, 0, 0};
  return world.add_body(plate).index;
}

/// A pile that falls asleep half-way through the steps of its case.
World falling_asleep() {
  World pile = cubes(cs550::Quality::Game, 0);
  pile.settings().sleeping = true;
  World later = pile;
  while (later.stats().asleep == 0) {
    if (later.step_count() > most_steps_awake) throw std::runtime_error("the pile stays awake");
    later.step(cs550::test::step_length);
  }
  while (pile.step_count() + steps / 2 < later.step_count()) pile.step(cs550::test::step_length);
  return pile;
}

constexpr cs550::Index first_exchanged = 1;

/// Removes a body in every fifth step and lets another one, of the same index, fall onto the pile.
void exchange_bodies(World& world, int step) {
  if (step % 5 != 0) return;
  world.remove_body(world.id_at(first_exchanged + step));
  world.add_body(
      cs550::test::body_at(cs550::test::box_shape(cs550::Vec3::Constant(cs550::Real(0.3))),
                           {cs550::Real(step % 4), cs550::Real(step / 10), cs550::Real(3.5)}));
}

}  // namespace

int main() {
  using cs550::Quality;
  World pushed = cubes(Quality::Game, 0);
  const cs550::Index plate = add_plate(pushed);
  World checked = cubes(Quality::Game, 0);
  checked.settings().check_stages = true;
  World without_passes = cubes(Quality::Accurate, 0);
  without_passes.settings().iterations = 0;
  without_passes.settings().check_stages = true;
  bool same = true;
  for (const Case& pile : {
           Case{"accurate", cubes(Quality::Accurate, 0)},
           Case{"game", cubes(Quality::Game, 0)},
           Case{"bouncing", cubes(Quality::Game, cs550::Real(0.4))},
           Case{.name = "pushed by a plate", .world = pushed, .visitor = plate},
           Case{"falling asleep", falling_asleep()},
           Case{"with checks", checked},
           Case{"without biased passes", without_passes},
           Case{"with new bodies", cubes(Quality::Game, 0), exchange_bodies, first_exchanged},
       }) {
    same = compare(pile) && same;
  }
  return same ? 0 : 1;
}
