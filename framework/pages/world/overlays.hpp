#pragma once
/// @file overlays.hpp
/// Drawings on top of a world.

#include "drawing/drawing.hpp"
#include "pages/base/controls.hpp"
#include "pages/world/world_frame.hpp"

namespace cs550::pages {

/// Which drawings are shown.
struct Overlays {
  bool wireframe = false;    ///< bodies are transparent
  bool contacts = false;     ///< points and normals
  bool impulses = false;     ///< as arrows, all to the same scale
  bool feature_ids = false;  ///< of each contact point
  bool bounds = false;       ///< boxes of the broad phase
  bool tree = false;         ///< inner boxes of its tree
  bool velocities = false;   ///< linear velocities
  bool spins = false;        ///< angular velocities
  bool momenta = false;      ///< P and L
  bool centers = false;      ///< of mass

  /// Whether any drawing begins inside a body.
  bool are_inside() const { return velocities || spins || momenta || centers; }
};

void describe(Overlays& overlays, ControlVisitor& visit);

/// Draws the selected ones. @param length of a contact normal (m); other arrows are scaled to it
drawing::Drawing draw_overlays(const Overlays& overlays, const WorldFrame& frame,
                               const std::vector<MeshPtr>& meshes, Real length);

/// The outline of the selected body.
drawing::Drawing draw_selection(const HalfEdgeMesh& mesh, const Pose& pose);

}  // namespace cs550::pages
