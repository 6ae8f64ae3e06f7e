#pragma once
/// @file mass_properties.hpp
/// Exact mass properties of a polyhedron: volume, centroid and inertia.

#include "cs550/half_edge_mesh.hpp"

namespace cs550 {

/// The integrals of a solid of uniform density.
struct MassProperties {
  Real volume = 0;                   ///< m³; mass = density·volume
  Vec3 centroid = {0, 0, 0};         ///< in the frame of the mesh (m)
  Mat3 unit_inertia = Mat3::Zero();  ///< about the centroid, for density 1 (m⁵)
};

/// Integrates 1, x and x·xᵀ over the solid by the divergence theorem, in double precision, with
/// each face split into a fan of triangles. Mirtich, *Fast and Accurate Computation of Polyhedral
/// Mass Properties* (1996); Eberly, *Polyhedral Mass Properties (Revisited)* (2002). An inside-out
/// mesh has a negative volume.
MassProperties mass_properties(const HalfEdgeMesh& mesh);

}  // namespace cs550
