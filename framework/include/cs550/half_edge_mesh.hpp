#pragma once
/// @file half_edge_mesh.hpp
/// **Lab 2:** The shape of a body: a closed convex polyhedron whose neighbours can be walked.
/// Document §2; de Berg et al., *Computational Geometry*, §2.2 (doubly connected edge list).

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "cs550/math.hpp"

namespace cs550 {

/// One direction of an edge. It belongs to the face on its left, seen from outside.
/// Twins are adjacent in the array: the twin of half-edge `e` is `e ^ 1`, the edge that both are
/// halves of has number `e / 2`.
struct HalfEdge {
  Index vertex = no_index;  ///< points to
  Index next = no_index;    ///< counter-clockwise around the face
  Index prev = no_index;    ///< the one whose next is this
  Index twin = no_index;    ///< the other half, in the other direction
  Index face = no_index;    ///< on its left
};

/// A planar convex polygon.
struct Face {
  Index edge = no_index;  ///< any half-edge of its loop
  Plane plane;            ///< outward, in the frame of the vertices
};

/// A closed polyhedron, as indices into four arrays.
struct HalfEdgeMesh {
  std::vector<Vec3> vertices;      ///< body frame (m)
  std::vector<Index> vertex_edge;  ///< one half-edge that leaves each vertex
  std::vector<HalfEdge> edges;     ///< half-edges, twins adjacent
  std::vector<Face> faces;         ///< polygons

  /// An element by its index.
  /// @{
  const Vec3& vertex(Index v) const { return vertices[static_cast<std::size_t>(v)]; }
  const HalfEdge& edge(Index e) const { return edges[static_cast<std::size_t>(e)]; }
  const Face& face(Index f) const { return faces[static_cast<std::size_t>(f)]; }
  /// @}

  /// How many there are.
  /// @{
  Index vertex_count() const { return static_cast<Index>(vertices.size()); }
  /// Half-edges: twice the number of edges.
  Index edge_count() const { return static_cast<Index>(edges.size()); }
  Index face_count() const { return static_cast<Index>(faces.size()); }
  /// @}

  /// The vertex that a half-edge comes from.
  Index origin(Index e) const { return edge(edge(e).twin).vertex; }
  /// From origin to end, not normalised.
  Vec3 edge_vector(Index e) const { return vertex(edge(e).vertex) - vertex(origin(e)); }
};

/// The half-edges around a face or a vertex, for `for (Index e : face_edges(mesh, f))`.
/// @tparam Advance maps a half-edge to the one after it
template <class Advance>
class EdgeLoop {
 public:
  /// What a range-based for asks of an iterator, and no more.
  class Iterator {
   public:
    /// At a half-edge: before the walk, or back there after it.
    Iterator(Index edge, bool at_end, Advance advance)
        : edge_(edge), at_end_(at_end), advance_(advance) {}
    /// The three steps of a loop.
    /// @{
    Index operator*() const { return edge_; }
    Iterator& operator++() {
      edge_ = advance_(edge_);
      at_end_ = true;  // back at the first edge means done
      return *this;
    }
    bool operator!=(const Iterator& other) const {
      return edge_ != other.edge_ || at_end_ != other.at_end_;
    }
    /// @}

   private:
    Index edge_;
    bool at_end_;
    Advance advance_;
  };

  /// The loop through a half-edge.
  EdgeLoop(Index first, Advance advance) : first_(first), advance_(advance) {}
  /// Once around, each half-edge once.
  /// @{
  Iterator begin() const { return {first_, false, advance_}; }
  Iterator end() const { return {first_, true, advance_}; }
  /// @}

 private:
  Index first_;
  Advance advance_;
};

/// Follows `next`: the half-edges of one face, counter-clockwise.
struct AroundFace {
  const HalfEdgeMesh* mesh;  ///< whose links to follow
  /// The half-edge after `e`.
  Index operator()(Index e) const { return mesh->edge(e).next; }
};

/// Follows `twin, next`: the half-edges that leave one vertex, clockwise.
struct AroundVertex {
  const HalfEdgeMesh* mesh;  ///< whose links to follow
  /// The half-edge after `e`.
  Index operator()(Index e) const { return mesh->edge(e ^ 1).next; }  // the twin is e ^ 1
};

/// The half-edges of a face, counter-clockwise, from its own `edge`.
inline EdgeLoop<AroundFace> face_edges(const HalfEdgeMesh& mesh, Index face) {
  return {mesh.face(face).edge, AroundFace{&mesh}};
}

/// The half-edges that leave a vertex, clockwise, from its `vertex_edge`.
inline EdgeLoop<AroundVertex> vertex_edges(const HalfEdgeMesh& mesh, Index vertex) {
  return {mesh.vertex_edge[static_cast<std::size_t>(vertex)], AroundVertex{&mesh}};
}

/// Three vertices, counter-clockwise seen from outside.
using Triangle = std::array<Index, 3>;

/// What can be wrong with a list of triangles.
enum class MeshError : std::uint8_t {
  None,                 ///< nothing
  NoTriangles,          ///< the list is empty
  NonFiniteVertex,      ///< NaN or infinity
  IndexOutOfRange,      ///< a triangle names a vertex that does not exist
  DegenerateTriangle,   ///< a triangle names a vertex twice, or has no area
  DuplicateTriangle,    ///< two triangles have the same three vertices
  IsolatedVertex,       ///< no triangle uses the vertex
  OpenEdge,             ///< an edge with only one triangle: the surface has a hole
  NonManifoldEdge,      ///< an edge with three or more triangles
  InconsistentWinding,  ///< two triangles run along their common edge in the same direction
  InsideOut,            ///< consistently wound, but clockwise: the enclosed volume is negative
};

/// The first fault of a list of triangles, and the elements that show it.
struct MeshIssue {
  MeshError error = MeshError::None;                 ///< what is wrong
  Index triangle = no_index;                         ///< in the input list
  Index other_triangle = no_index;                   ///< the second one, for pairs
  Index vertex = no_index;                           ///< for faults of one vertex
  std::array<Index, 2> edge = {no_index, no_index};  ///< its end points, for faults of an edge

  /// Whether anything is wrong.
  explicit operator bool() const { return error != MeshError::None; }
};

/// A sentence for people: "edge 3–7 belongs to triangle 12 only: the surface is open".
std::string describe(const MeshIssue& issue);

/// A mesh, or why there is none.
struct MeshBuild {
  HalfEdgeMesh mesh;  ///< empty if there is an issue
  MeshIssue issue;    ///< false if there is a mesh
};

/// **L2.1**–**L2.4** Connects triangles into a half-edge mesh.
///
/// Checks in this order, each before the next is looked at: L2.1 the triangles themselves
/// (NoTriangles, NonFiniteVertex, IndexOutOfRange, DegenerateTriangle, DuplicateTriangle,
/// IsolatedVertex); L2.2 their edges (NonManifoldEdge, InconsistentWinding, OpenEdge), giving twins
/// neighbouring places; L2.3 links next, prev, face and vertex_edge; L2.4 fills face planes by
/// face_plane() and refuses InsideOut. A triangle has no area when twice its area is below 1e-7 of
/// the square of its longest edge. Face `f` of the result is triangle `f`.
/// O(T log T) for T triangles, or expected O(T) with hashing.
/// @param vertices body frame (m)
/// @param triangles counter-clockwise seen from outside
MeshBuild build_half_edge_mesh(std::span<const Vec3> vertices, std::span<const Triangle> triangles);

/// **L2.5** The plane of a polygon by Newell's method: the normal is the sum over its edges (a, b) of
/// (a − c) × (b − c), normalised, which no single short edge or reflex corner spoils; the offset is
/// that of the centroid c of its corners. Newell, Newell & Sancha (1972); Ericson §12.4.1.
/// @param corners counter-clockwise seen from where the normal points to, any frame (m); three or more
Plane polygon_plane(std::span<const Vec3> corners);

/// **L2.5** The plane of a face: polygon_plane() of its corners, in the order of its loop.
Plane face_plane(const HalfEdgeMesh& mesh, Index face);

/// Given: the mesh without what is marked as removed, which are half-edges whose `face` and faces
/// whose `edge` is no_index, and the vertices that no half-edge points to any more. An edge goes when
/// both of its halves are marked. What stays keeps its order and its planes, and gets new numbers;
/// vertex_edge is made anew. A link to something removed becomes no_index, for validate() to find.
HalfEdgeMesh without_removed(const HalfEdgeMesh& mesh);

/// The default tolerance of merge_coplanar_faces(), relative to the size of the mesh.
inline constexpr Real coplanar_tolerance = Real(1e-5);

/// **L2.6** (one shared edge) and **L2.7** (chains of shared edges) Merges coplanar neighbours into
/// polygons. Faces are merged only if every vertex of the *merged* face lies within tolerance·size
/// of that face's Newell plane (nearly coplanar is not transitive), its outline stays convex, and no
/// other vertex comes out in front of it. Where the union has a reflex vertex, the coplanar
/// faces behind that vertex join it: a flat face becomes one polygon however it was cut. A chain of shared edges goes
/// as a whole, with its inner vertices; a vertex that is left with two edges on a straight line goes
/// too. Unused vertices are removed and the rest keep their order. The result does not depend on
/// the order of the triangles, and merging it again changes nothing. Matters before lab 5: a
/// triangular reference face clips away half of a box's contact polygon.
/// @param tolerance relative to the largest extent of the mesh's bounds
HalfEdgeMesh merge_coplanar_faces(const HalfEdgeMesh& mesh, Real tolerance = coplanar_tolerance);

}  // namespace cs550
