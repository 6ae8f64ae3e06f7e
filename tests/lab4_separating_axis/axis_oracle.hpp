#pragma once
// Checks of lab 4's answers against the separation by brute force.

#include <string>
#include <vector>

#include "cs550/separating_axis.hpp"
#include "helpers/exact_separation.hpp"
#include "helpers/random.hpp"
#include "helpers/require.hpp"
#include "helpers/story.hpp"

namespace cs550::test {

/// A pair of bodies, with the data of the oracle.
struct TestPair {
  PosedShape a;
  PosedShape b;
  std::string names;

  ExactBody exact_a() const { return {a, a.pose.position}; }
  ExactBody exact_b() const { return {b, a.pose.position}; }
  Real smaller_radius() const { return std::min(a.shape->radius, b.shape->radius); }
  Real larger_radius() const { return std::max(a.shape->radius, b.shape->radius); }
  TestPair swapped() const { return {b, a, names + ", swapped"}; }
  /// Moves B towards A, to a share of their distance.
  void approach(Real share) {
    b.pose.position = a.pose.position + share * (b.pose.position - a.pose.position);
  }
};

/// A fixture, enlarged.
ShapePtr scaled_shape(const std::string& name, Real factor);

/// Two shapes with random orientations, so close that about half of the pairs overlap.
TestPair random_pair(Random& random, const std::vector<ShapePtr>& shapes,
                     const Vec3& place = Vec3::Zero());

/// Small shapes of all kinds, enlarged.
std::vector<ShapePtr> small_shapes(Real factor = 1);

/// The best separation over all pairs of edges with crossing arcs. `clear` leaves out crossings
/// that float may miss, close to an end or at a small angle.
struct ExactEdges {
  double clear = -HUGE_VAL;
  double any = -HUGE_VAL;
};
ExactEdges exact_edges(const TestPair& pair);

/// Adds the pair to the story.
Story about(Story story, const TestPair& pair);

/// The best axis beside the one found, and the latter on the Gauss maps.
std::string axis_picture(const TestPair& pair, const SeparatingAxis& got);

/// Checks that an answer is consistent: a unit axis, its separation, and the queries behind it. If
/// the separation is within the margin, no axis may be better.
/// @param tolerance relative to the larger radius
void require_best_axis(const Story& story, const TestPair& pair, const SeparatingAxis& answer,
                       Real margin, double tolerance);

/// Rounding of a few dozen operations in float, relative to the size of the bodies.
inline constexpr double rounding = 5e-6;

}  // namespace cs550::test
