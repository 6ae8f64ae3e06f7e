#pragma once
/// @file convex_shape.hpp
/// A shape that bodies share, and a shape placed in the world.

#include <memory>
#include <span>
#include <string>

#include "cs550/half_edge_mesh.hpp"

namespace cs550 {

/// The most edges that a shape may have: feature ids keep 14 bits for each element.
inline constexpr Index max_shape_edges = 1 << 14;
/// The most vertices of one face: clipping works in a polygon of fixed capacity.
inline constexpr Index max_face_vertices = 128;

/// A convex polyhedron, immutable once made, its origin at its centroid.
struct ConvexShape {
  HalfEdgeMesh mesh;                 ///< body frame, coplanar faces merged
  Real volume = 0;                   ///< m³
  Mat3 unit_inertia = Mat3::Zero();  ///< about the origin, for density 1 (m⁵)
  Vec3 source_origin = {0, 0, 0};    ///< where the frame of the input had its origin (body frame)
  Bounds bounds;                     ///< body frame
  Real radius = 0;                   ///< of the smallest sphere about the origin that holds it (m)
  Real smallest_half_extent = 0;     ///< half the smallest width over the face normals (m)
};

/// How shapes are shared: by bodies, worlds and threads, since nobody can change them.
using ShapePtr = std::shared_ptr<const ConvexShape>;

/// A shape, or a sentence that says why there is none and how to mend it.
struct ShapeResult {
  ShapePtr shape;     ///< null if there is an error
  std::string error;  ///< empty if there is a shape

  /// Whether there is a shape.
  explicit operator bool() const { return shape != nullptr; }
};

/// Moves a valid mesh to its centroid and measures it. Calls no lab function, so that recorded
/// meshes need none; faces are taken as they are. Refuses a mesh that validate() refuses, more than
/// max_shape_edges edges or a face of more than max_face_vertices vertices.
ShapeResult make_shape(const HalfEdgeMesh& mesh);

/// Builds, merges and measures: build_half_edge_mesh(), merge_coplanar_faces(), make_shape().
/// @param triangles counter-clockwise seen from outside
ShapeResult make_shape(std::span<const Vec3> vertices, std::span<const Triangle> triangles);

/// A shape at a pose, as a view: it does not own the shape.
struct PosedShape {
  const ConvexShape* shape = nullptr;  ///< must outlive this view
  Pose pose;                           ///< body → world

  /// Its mesh, in the body frame.
  const HalfEdgeMesh& mesh() const { return shape->mesh; }
  /// A vertex in the world (m).
  Vec3 vertex(Index v) const;
  /// The plane of a face in the world.
  Plane plane(Index f) const;
};

/// Bounds in the world of a posed shape.
Bounds world_bounds(const PosedShape& body);

}  // namespace cs550
