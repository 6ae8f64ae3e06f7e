#pragma once
// The oracle of lab 4: brute force in double precision over all vertices, all face normals and all
// pairs of edges, without Gauss maps or hill climbing.

#include <cmath>
#include <string>
#include <vector>

#include "cs550/separating_axis.hpp"
#include "helpers/random.hpp"
#include "helpers/require.hpp"
#include "helpers/story.hpp"

namespace cs550::test {

using Vec3d = Eigen::Vector3d;

/// A posed shape in double precision, relative to a given point of the world, so that it is exact
/// even at large world coordinates.
struct ExactBody {
  std::vector<Vec3d> vertices;  ///< relative to that point (m)
  std::vector<Vec3d> normals;   ///< by face, world frame
  std::vector<Vec3d> edges;     ///< unit, by number of the edge (half-edge / 2), world frame
  double size = 0;              ///< distance of the farthest vertex from the body's origin (m)

  ExactBody(const PosedShape& body, const Vec3& viewer);
};

/// min over B of n·b − max over A of n·a: the separation along the axis n (A → B).
double separation_along(const ExactBody& a, const ExactBody& b, const Vec3d& axis);

/// The largest separations by brute force, or −infinity if there is no axis of a kind.
struct BestSeparations {
  double face_a = -HUGE_VAL;
  double face_b = -HUGE_VAL;
  double edges = -HUGE_VAL;     ///< over both directions of every cross product of two edges
  Vec3d axis = Vec3d::UnitZ();  ///< of the largest of all, A → B

  double faces() const { return std::max(face_a, face_b); }
  double largest() const { return std::max(faces(), edges); }
};
BestSeparations best_separations(const ExactBody& a, const ExactBody& b);

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
};

/// A fixture, enlarged.
ShapePtr scaled_shape(const std::string& name, Real factor);

/// Two shapes with random orientations, so close that about half of the pairs overlap.
TestPair random_pair(Random& random, const std::vector<ShapePtr>& shapes,
                     const Vec3& place = Vec3::Zero());

/// Small shapes of all kinds, enlarged.
std::vector<ShapePtr> small_shapes(Real factor = 1);

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
