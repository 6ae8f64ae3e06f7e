#pragma once
/// @file solid.hpp
/// A shaded body.

#include <memory>
#include <vector>

#include "cs550/half_edge_mesh.hpp"
#include "pages/base/colours.hpp"

namespace cs550::pages {

/// A shared mesh.
using MeshPtr = std::shared_ptr<const HalfEdgeMesh>;

/// A mesh with a pose and a colour. With an opacity below 1 it is translucent.
struct Solid {
  MeshPtr mesh;                ///< body frame; if null, nothing is drawn
  Pose pose;                   ///< body → world
  Rgba colour = {1, 1, 1, 1};  ///< of the faces; edges are darker
  bool is_ground = false;      ///< has a grid of 1 m, casts no shadow

  bool operator==(const Solid& other) const {
    return mesh == other.mesh && pose.position == other.pose.position &&
           pose.orientation.coeffs() == other.pose.orientation.coeffs() && colour == other.colour &&
           is_ground == other.is_ground;
  }
};

}  // namespace cs550::pages
