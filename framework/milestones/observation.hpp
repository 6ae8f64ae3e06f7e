#pragma once
/// @file observation.hpp
/// Named quantities of a world at one moment, to compare a student's engine with the recorded
/// reference.

#include <string>
#include <vector>

#include "cs550/scene.hpp"

namespace cs550::milestones {

/// A measured value, with a tolerance for other correct engines.
struct Quantity {
  std::string name;            ///< "teapot: position"
  std::string unit;            ///< of the values
  std::vector<double> values;  ///< a number, a vector, or an orientation (w, x, y, z)
  double tolerance = 0;        ///< in the unit; of an orientation in rad

  bool is_orientation() const { return values.size() == 4; }
};

/// All quantities of one moment, always in the same order.
using Observation = std::vector<Quantity>;

/// The distance of two values of a quantity: the length of their difference, or the angle between
/// two orientations (rad). NaN if either contains one.
double distance(const std::vector<double>& a, const std::vector<double>& b);

/// What is observed. Some observations call a lab's functions directly, so that a stage can be
/// checked before the stages that use it are written.
/// @{
/// Position and orientation of every body that moves.
Observation poses(const World& world, const Scene& scene);
/// Vertices, edges and faces of every body's mesh, and the poses.
Observation meshes_and_poses(const World& world, const Scene& scene);
/// The lowest point of every body, by lab 3's support().
Observation lowest_points(const World& world, const Scene& scene);
/// The separation of every two bodies, by lab 4's find_separating_axis().
Observation separations(const World& world, const Scene& scene);
/// Number and middle of the contact points of every two bodies, and the depth of the deepest, by
/// lab 5's build_manifold().
Observation contact_patches(const World& world, const Scene& scene);
/// For a heap of bodies, whose poses are chaotic: energy, mean height, and the number of bodies
/// that have not moved from their start.
Observation heap(const World& world, const Scene& scene);
/// @}

}  // namespace cs550::milestones
