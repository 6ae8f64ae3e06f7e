#pragma once
/// @file observation.hpp
/// What is compared between a student's engine and the recorded reference: named quantities of a
/// world at one moment.

#include <string>
#include <vector>

#include "cs550/scene.hpp"

namespace cs550::milestones {

/// One measured value, and how far another sound engine may be from it.
struct Quantity {
  std::string name;            ///< "teapot: position"
  std::string unit;            ///< of the values
  std::vector<double> values;  ///< a number, a vector, or an orientation (w, x, y, z)
  double tolerance = 0;        ///< in the unit; of an orientation in rad

  bool is_orientation() const { return values.size() == 4; }
};

/// All quantities of one moment, always the same ones in the same order.
using Observation = std::vector<Quantity>;

/// How far two values of a quantity are apart: the length of their difference, or the angle between
/// two orientations (rad). NaN if either has one.
double distance(const std::vector<double>& a, const std::vector<double>& b);

/// What to look at. The later ones call functions of the labs themselves, so that a stage can be
/// seen before the stages that use it exist.
/// @{
/// Position and orientation of every body that moves.
Observation poses(const World& world, const Scene& scene);
/// Vertices, edges and faces of every body's mesh, and the poses.
Observation meshes_and_poses(const World& world, const Scene& scene);
/// The lowest point of every body, by lab 3's support().
Observation lowest_points(const World& world, const Scene& scene);
/// How far every two bodies are apart, by lab 4's find_separating_axis().
Observation separations(const World& world, const Scene& scene);
/// Number and middle of the contact points of every two bodies, and the depth of the deepest, by
/// lab 5's build_manifold().
Observation contact_patches(const World& world, const Scene& scene);
/// What can be said of a heap of bodies, whose poses are chaotic: energy, mean height, and how many
/// still are where they began.
Observation heap(const World& world, const Scene& scene);
/// @}

}  // namespace cs550::milestones
