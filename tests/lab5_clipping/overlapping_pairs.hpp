#pragma once
/// @file overlapping_pairs.hpp
/// Random pairs of overlapping fixtures, and checks of build_manifold() on them. The axes are those
/// of find_separating_axis(), which lab 4 tests.

#include <array>
#include <string>
#include <vector>

#include "lab5_clipping/contacts.hpp"
#include "lab5_clipping/pictures.hpp"

namespace cs550::test {

/// The allowed difference between the depth of a manifold and the largest separation over all axes:
/// faces are preferred by edge_preference. Rounding is added.
inline Real depth_tolerance(const PosedShape& a, const PosedShape& b) {
  return edge_preference * std::min(a.shape->radius, b.shape->radius) +
         Real(3e-6) * (a.shape->radius + b.shape->radius);
}

/// Draws two bodies until they overlap by less than 0.4 of the smaller radius.
/// @param origin position of the first body
struct OverlappingPair {
  Placed a;
  Placed b;
  SeparatingAxis axis;

  OverlappingPair(Random& random, const std::vector<ShapePtr>& shapes, const Vec3& origin)
      : a(pick(random, shapes), Pose{}), b(pick(random, shapes), Pose{}) {
    const Real smaller = std::min(a.shape->radius, b.shape->radius);
    do {
      const Real distance = random.real(0, a.shape->radius + b.shape->radius);
      a.body.pose = {origin, random.orientation()};
      b.body.pose = {origin + distance * random.unit_vector(), random.orientation()};
      axis = find_separating_axis(a.body, b.body, {}, 0);
    } while (axis.separation > 0 || axis.separation < Real(-0.4) * smaller);
  }

 private:
  static ShapePtr pick(Random& random, const std::vector<ShapePtr>& shapes) {
    return shapes[random.integer(0, static_cast<int>(shapes.size()) - 1)];
  }
};

/// The number of manifolds of each kind.
using ReferenceCount = std::array<int, 4>;

/// Checks that the manifold of a pair is valid and reports the depth of the axis.
inline void require_depth(Story story, const PosedShape& a, const PosedShape& b,
                          const SeparatingAxis& axis, ReferenceCount& seen, SourceLine at = {}) {
  const Manifold manifold = build_manifold(a, b, axis, 0);
  ++seen[static_cast<std::size_t>(manifold.reference)];
  story.given("separation of A's best face", axis.face_a.separation, "m")
      .given("separation of B's best face", axis.face_b.separation, "m");
  if (axis.edges) story.given("separation of the best edges", axis.edges.separation, "m");
  require(story.expect_at_least("points of the manifold", manifold.points.size(), 1, "", at));
  story.picture([&] { return manifold_picture(a, b, manifold, axis.axis); });
  const double tolerance = static_cast<double>(depth_tolerance(a, b));
  const Real size = a.shape->radius + b.shape->radius;
  require(story.expect_near("deepest point, against the largest separation of all axes",
                            static_cast<double>(deepest_separation(manifold)),
                            static_cast<double>(axis.separation), tolerance, "m", at));
  require(story.expect_near("how far apart the bodies are along the manifold's normal",
                            separation_along(a, b, manifold.normal),
                            static_cast<double>(axis.separation), tolerance, "m", at));
  require_sound(story, a, b, manifold, size, at);
}

}  // namespace cs550::test
