#pragma once
/// @file piles.hpp
/// Piles of boxes that must stand still, whatever their place, order, material and size.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "lab7_constraint_solver/pictures.hpp"
#include "lab7_constraint_solver/solver_world.hpp"

namespace cs550::test {

/// A variation of a pile. It may not matter.
struct Variation {
  std::uint32_t seed;
  Real yaw_degrees;
  Real density;
  Real size;      ///< of a box (m); gravity and the length unit scale with it
  Real sideways;  ///< each box is moved by up to this share of its size
};

inline constexpr Real percent = Real(0.01);

inline World scaled_world(Real size) {
  World world = checked_world();
  world.settings().length_unit = size;
  world.settings().gravity *= size;
  return world;
}

/// Boxes at positions in multiples of their size, each moved sideways, added in a shuffled order.
/// Returns their ids in the order of the positions.
inline std::vector<BodyId> add_boxes(World& world, const std::vector<Vec3>& places,
                                     const Variation& variation) {
  Random random(variation.seed);
  const ShapePtr shape = box_shape(Vec3::Constant(variation.size / 2));
  const Quat turn = yaw(variation.yaw_degrees * pi / 180);
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[random.integer(0, static_cast<int>(i) - 1)]);
  }
  std::vector<BodyId> names(places.size());
  for (const std::size_t i : order) {
    const Real x = random.real(-variation.sideways, variation.sideways);
    const Real y = random.real(-variation.sideways, variation.sideways);
    BodyDef def = body_at(shape, turn * (variation.size * (places[i] + Vec3(x, y, 0))));
    def.pose.orientation = turn;
    def.density = variation.density;
    names[i] = world.add_body(def);
  }
  return names;
}

inline Story vary(Story story, const Variation& variation) {
  story.seed(variation.seed).given("yaw", variation.yaw_degrees, "°");
  story.given("density", variation.density, "kg/m³").given("box", variation.size, "m");
  return story;
}

/// Ten boxes on each other.
inline void require_tower(const Variation& variation) {
  Story property(
      "ten boxes on each other sink less than 1 cm in 1 s, then stand for 59 s (lengths in boxes "
      "of 1 m)");
  property.likely("without warm starting the load of nine boxes is found anew in every substep")
      .likely(
          "passes in one direction only let the tower swing up: backwards is the exact reverse");

  Story story = vary(property, variation);
  World world = scaled_world(variation.size);
  add_floor(world, 50 * variation.size, Real(0.6), variation.size / 2);
  std::vector<Vec3> places;
  places.reserve(10);
  for (int i = 0; i < 10; ++i) places.emplace_back(0, 0, Real(0.5) + static_cast<Real>(i));
  const BodyId top = add_boxes(world, places, variation).back();
  const Vec3 start = world.body(top).pose.position;
  const World at_start = world;
  story.picture([&] { return standing_picture(at_start, world); });
  run_world(world, story, 1);
  const Vec3 settled = world.body(top).pose.position;
  run_world(world, story, 59);
  const Vec3 moved = (world.body(top).pose.position - settled) / variation.size;
  const auto mm = [](Real length) { return static_cast<double>(1000 * length); };
  require(story.expect_at_most("sinking of the top in the first second",
                               mm((start - settled).z() / variation.size), 10, "mm"));
  require(story.expect_at_most("sinking of the top in the next 59 s", mm(-moved.z()), 1, "mm"));
  require(story.expect_at_most("sideways drift of the top", mm(moved.head<2>().norm()), 1, "mm"));
}

/// A pyramid of boxes.
inline void require_pyramid(int rows, const Variation& variation) {
  Story property(
      "a pyramid drifts less than 1 cm in 10 s and rests in the last 5 s (lengths in boxes of 1 "
      "m)");
  property.likely("friction that forgets its accumulated impulse lets the rows creep apart");
  std::vector<Vec3> places;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < rows - row; ++i) {
      const Real x =
          Real(1.05) * (static_cast<Real>(i) - Real(0.5) * static_cast<Real>(rows - 1 - row));
      places.emplace_back(x, 0, Real(0.5) + static_cast<Real>(row));
    }
  }

  Story story = vary(property, variation);
  story.given("rows", rows);
  World world = scaled_world(variation.size);
  add_floor(world, 50 * variation.size, Real(0.6), variation.size / 2);
  const std::vector<BodyId> boxes = add_boxes(world, places, variation);
  std::vector<Vec3> start;
  start.reserve(boxes.size());
  for (const BodyId box : boxes) start.push_back(world.body(box).pose.position);
  const World at_start = world;
  story.picture([&] { return standing_picture(at_start, world); });

  run_world(world, story, 5);
  double squares = 0;
  int samples = 0;
  for (int i = 0; i < 300; ++i) {
    step_world(world, story);
    for (const BodyId box : boxes) {
      squares += static_cast<double>(world.body(box).linear_velocity.squaredNorm());
      ++samples;
    }
  }
  double drift = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vec3 moved = world.body(boxes[i]).pose.position - start[i];
    drift = std::max(drift, static_cast<double>(moved.norm()));
  }
  const double mm = 1000 / static_cast<double>(variation.size);
  require(story.expect_at_most("largest drift", mm * drift, 10, "mm"));
  require(story.expect_at_most("rms speed", mm * std::sqrt(squares / samples), 1, "mm/s"));
}

}  // namespace cs550::test
