#pragma once
/// @file solid.hpp
/// A body as it is shown.

#include <memory>
#include <vector>

#include "cs550/half_edge_mesh.hpp"
#include "pages/base/colours.hpp"

namespace cs550::pages {

/// How meshes are shared.
using MeshPtr = std::shared_ptr<const HalfEdgeMesh>;

/// A mesh at a place, in a colour. An opacity below 1 shows what is behind.
struct Solid {
  MeshPtr mesh;                ///< body frame; nothing is drawn without
  Pose pose;                   ///< body → world
  Rgba colour = {1, 1, 1, 1};  ///< of its faces; edges are darker
  bool is_ground = false;      ///< has a grid of metres, throws no shadow

  bool operator==(const Solid& other) const {
    return mesh == other.mesh && pose.position == other.pose.position &&
           pose.orientation.coeffs() == other.pose.orientation.coeffs() && colour == other.colour &&
           is_ground == other.is_ground;
  }
};

}  // namespace cs550::pages
