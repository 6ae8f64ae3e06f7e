#pragma once
/// @file overlays.hpp
/// What can be drawn over a world.

#include "drawing/drawing.hpp"
#include "pages/base/controls.hpp"
#include "pages/world/world_frame.hpp"

namespace cs550::pages {

/// Switches of what is drawn.
struct Overlays {
  bool wireframe = false;    ///< bodies show through
  bool contacts = false;     ///< points and normals
  bool impulses = false;     ///< as arrows, one length unit for the weight of a step
  bool feature_ids = false;  ///< which features meet in a point
  bool bounds = false;       ///< boxes of the broad phase
  bool tree = false;         ///< boxes of its tree
  bool velocities = false;   ///< linear ones
  bool spins = false;        ///< angular velocities
  bool momenta = false;      ///< P and L
  bool centers = false;      ///< of mass

  /// Whether what is drawn begins inside of bodies.
  bool are_inside() const { return velocities || spins || momenta || centers; }
};

void describe(Overlays& overlays, ControlVisitor& visit);

/// What the switches ask for. @param length of a contact normal (m); other arrows follow it
drawing::Drawing draw_overlays(const Overlays& overlays, const WorldFrame& frame,
                               const std::vector<MeshPtr>& meshes, Real length);

/// The outline of a body, around the selected one.
drawing::Drawing draw_selection(const HalfEdgeMesh& mesh, const Pose& pose);

}  // namespace cs550::pages
