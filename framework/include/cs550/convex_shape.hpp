#pragma once
/// @file convex_shape.hpp
/// Convex shapes, which bodies share, and shapes placed in the world.

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cs550/half_edge_mesh.hpp"

namespace cs550 {

/// The largest number of edges of a shape: feature ids have 14 bits per element.
inline constexpr Index max_shape_edges = 1 << 14;
/// The largest number of vertices of a face: clipping uses polygons of fixed capacity.
inline constexpr Index max_face_vertices = 128;

/// The sine of the angle that an edge of a merged face may enclose with the plane of that face. Lab 4
/// relies on edges that are perpendicular to the normals beside them.
inline constexpr Real max_edge_slope = Real(2e-4);

/// The planes of four faces, coordinate by coordinate, in one line of a cache.
struct alignas(64) PlaneBlock {
  std::array<Real, 4> x;       ///< of the normals
  std::array<Real, 4> y;       ///< of the normals
  std::array<Real, 4> z;       ///< of the normals
  std::array<Real, 4> offset;  ///< (m)
};

/// A convex polyhedron with its origin at its centroid. Immutable once made.
struct ConvexShape {
  HalfEdgeMesh mesh;  ///< body frame, coplanar faces merged
  /// The planes of the mesh again, for searches that read them all. The last face fills the last
  /// block.
  std::vector<PlaneBlock> plane_blocks;
  Real volume = 0;                   ///< m³
  Mat3 unit_inertia = Mat3::Zero();  ///< about the origin, for density 1 (m⁵)
  Vec3 source_origin = {0, 0, 0};    ///< origin of the input's frame, in the body frame (m)
  Bounds bounds;                     ///< body frame
  Real radius = 0;                   ///< of the smallest enclosing sphere about the origin (m)
  Real inner_radius = 0;          ///< of the largest sphere about the origin inside the shape (m)
  Real smallest_half_extent = 0;  ///< half the smallest width along any face normal (m)
};

/// Shapes are immutable, so that bodies, worlds and threads can share them.
using ShapePtr = std::shared_ptr<const ConvexShape>;

/// A shape, or an error message with the reason and the remedy.
struct ShapeResult {
  ShapePtr shape;     ///< null on error
  std::string error;  ///< empty on success

  /// Whether there is a shape.
  explicit operator bool() const { return shape != nullptr; }
};

/// Moves a mesh to its centroid and computes its mass properties and bounds. Calls no lab function,
/// so that recorded meshes work without any; coplanar faces are not merged. Rejects a mesh that
/// validate() rejects, has more than max_shape_edges edges, or has a face with more than
/// max_face_vertices vertices.
ShapeResult make_shape(const HalfEdgeMesh& mesh);

/// Makes a shape from triangles by build_half_edge_mesh(), merge_coplanar_faces() and make_shape().
/// If an edge exceeds max_edge_slope, and not only by rounding, or if more than a tenth of the
/// volume is lost, faces are merged with a smaller tolerance. Rejects a mesh that loses as much with
/// the smallest one.
/// @param triangles counter-clockwise seen from outside
ShapeResult make_shape(std::span<const Vec3> vertices, std::span<const Triangle> triangles);

/// A shape at a pose. A view: it does not own the shape.
struct PosedShape {
  const ConvexShape* shape = nullptr;  ///< must outlive this view
  Pose pose;                           ///< body → world

  /// The mesh, in the body frame.
  const HalfEdgeMesh& mesh() const { return shape->mesh; }
  /// A vertex in the world frame (m).
  Vec3 vertex(Index v) const;
  /// The plane of a face in the world frame.
  Plane plane(Index f) const;
};

/// The bounds of a posed shape in the world frame.
Bounds world_bounds(const PosedShape& body);

}  // namespace cs550
