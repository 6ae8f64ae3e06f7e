#pragma once
/// @file half_edge_mesh.hpp
/// **Lab 2:** The half-edge mesh: a closed convex polyhedron with links between neighbouring
/// elements. Document §2; de Berg et al., *Computational Geometry*, §2.2 (doubly connected edge
/// list).

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "cs550/math.hpp"

namespace cs550 {

/// One direction of an edge. It belongs to the face on its left, seen from outside. Twins are
/// adjacent in the array: the twin of half-edge `e` is `e ^ 1`, and together they are edge `e / 2`.
struct HalfEdge {
  Index vertex = no_index;  ///< the vertex that it points to
  Index next = no_index;    ///< the next half-edge of the face, counter-clockwise
  Index prev = no_index;    ///< the previous half-edge of the face
  Index twin = no_index;    ///< the half-edge in the opposite direction
  Index face = no_index;    ///< the face on its left
};

/// A planar convex polygon.
struct Face {
  Index edge = no_index;  ///< any half-edge of its loop
  Plane plane;            ///< outward, in the frame of the vertices
};

/// A closed polyhedron, stored in four arrays that refer to each other by index.
struct HalfEdgeMesh {
  std::vector<Vec3> vertices;      ///< body frame (m)
  std::vector<Index> vertex_edge;  ///< for each vertex, one half-edge that leaves it
  std::vector<HalfEdge> edges;     ///< half-edges, twins adjacent
  std::vector<Face> faces;         ///< polygons

  /// The element at an index.
  /// @{
  const Vec3& vertex(Index v) const { return vertices[static_cast<std::size_t>(v)]; }
  const HalfEdge& edge(Index e) const { return edges[static_cast<std::size_t>(e)]; }
  const Face& face(Index f) const { return faces[static_cast<std::size_t>(f)]; }
  /// @}

  /// The number of elements.
  /// @{
  Index vertex_count() const { return static_cast<Index>(vertices.size()); }
  /// Half-edges: twice the number of edges.
  Index edge_count() const { return static_cast<Index>(edges.size()); }
  Index face_count() const { return static_cast<Index>(faces.size()); }
  /// @}

  /// The vertex that a half-edge starts from.
  Index origin(Index e) const { return edge(edge(e).twin).vertex; }
  /// The vector from the start to the end of a half-edge, not normalised (m).
  Vec3 edge_vector(Index e) const { return vertex(edge(e).vertex) - vertex(origin(e)); }
};

/// A range over the half-edges around a face or a vertex, as in `for (Index e : face_edges(mesh,
/// f))`.
/// @tparam Advance maps a half-edge to the one after it
template <class Advance>
class EdgeLoop {
 public:
  /// The minimum that a range-based for loop needs.
  class Iterator {
   public:
    /// At a half-edge: `at_end` distinguishes the end of the walk from its start.
    Iterator(Index edge, bool at_end, Advance advance)
        : edge_(edge), at_end_(at_end), advance_(advance) {}
    /// The operations of a loop.
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

  /// The loop that contains a half-edge.
  EdgeLoop(Index first, Advance advance) : first_(first), advance_(advance) {}
  /// Visits each half-edge once.
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
  const HalfEdgeMesh* mesh;  ///< the mesh to walk on
  /// The half-edge after `e`.
  Index operator()(Index e) const { return mesh->edge(e).next; }
};

/// Follows `twin`, then `next`: the half-edges that leave one vertex, clockwise.
struct AroundVertex {
  const HalfEdgeMesh* mesh;  ///< the mesh to walk on
  /// The half-edge after `e`.
  Index operator()(Index e) const { return mesh->edge(e ^ 1).next; }  // the twin is e ^ 1
};

/// The half-edges of a face, counter-clockwise, starting at its `edge`.
inline EdgeLoop<AroundFace> face_edges(const HalfEdgeMesh& mesh, Index face) {
  return {mesh.face(face).edge, AroundFace{&mesh}};
}

/// The half-edges that leave a vertex, clockwise, starting at its `vertex_edge`.
inline EdgeLoop<AroundVertex> vertex_edges(const HalfEdgeMesh& mesh, Index vertex) {
  return {mesh.vertex_edge[static_cast<std::size_t>(vertex)], AroundVertex{&mesh}};
}

/// Three vertices, counter-clockwise seen from outside.
using Triangle = std::array<Index, 3>;

/// The faults of a list of triangles.
enum class MeshError : std::uint8_t {
  None,                 ///< no fault
  NoTriangles,          ///< the list is empty
  NonFiniteVertex,      ///< a coordinate is NaN or infinite
  IndexOutOfRange,      ///< a triangle refers to a vertex that does not exist
  DegenerateTriangle,   ///< a triangle uses a vertex twice, or has no area
  DuplicateTriangle,    ///< two triangles have the same three vertices, in any order
  IsolatedVertex,       ///< no triangle uses the vertex
  OpenEdge,             ///< an edge with only one triangle: the surface has a hole
  NonManifoldEdge,      ///< an edge with three or more triangles
  InconsistentWinding,  ///< two triangles traverse their common edge in the same direction
  InsideOut,            ///< consistently wound, but clockwise: the enclosed volume is negative
};

/// The first fault of a list of triangles and the elements at fault. Each fault fills these fields,
/// and the others are no_index:
/// - NoTriangles, InsideOut: none
/// - NonFiniteVertex, IsolatedVertex: vertex
/// - IndexOutOfRange: triangle, and as vertex the index that it contains
/// - DegenerateTriangle: triangle
/// - DuplicateTriangle: triangle, other_triangle
/// - OpenEdge: triangle, edge
/// - NonManifoldEdge, InconsistentWinding: edge, and two of its triangles as triangle and
///   other_triangle
///
/// Two triangles or two end points may be in either order. If several elements have the same fault,
/// any of them may be reported.
struct MeshIssue {
  MeshError error = MeshError::None;                 ///< the kind of fault
  Index triangle = no_index;                         ///< index in the input list
  Index other_triangle = no_index;                   ///< the second triangle of a pair
  Index vertex = no_index;                           ///< the vertex at fault
  std::array<Index, 2> edge = {no_index, no_index};  ///< the end points of the edge at fault

  /// Whether there is a fault.
  explicit operator bool() const { return error != MeshError::None; }
};

/// An issue in words: "edge 3–7 belongs to triangle 12 only: the surface is open".
std::string describe(const MeshIssue& issue);

/// A mesh, or the reason why there is none.
struct MeshBuild {
  HalfEdgeMesh mesh;  ///< empty if there is an issue
  MeshIssue issue;    ///< converts to false if there is a mesh
};

/// **L2.1**–**L2.4** Connects triangles into a half-edge mesh. Face `f` of the result is triangle
/// `f`.
///
/// Faults are looked for in the order below, and each check is complete before the next one begins.
/// - L2.1 checks the triangles: NoTriangles, NonFiniteVertex, IndexOutOfRange, DegenerateTriangle,
///   DuplicateTriangle, IsolatedVertex. A triangle has no area if twice its area is at most 1e-7 of
///   the square of its longest edge.
/// - L2.2 checks the edges: NonManifoldEdge, InconsistentWinding, OpenEdge. It stores twins next to
///   each other.
/// - L2.3 sets next, prev, face and vertex_edge.
/// - L2.4 computes the planes with face_plane() and checks for InsideOut.
///
/// Runs in O(T log T) for T triangles, or in expected O(T) with hashing.
/// @param vertices body frame (m)
/// @param triangles counter-clockwise seen from outside
MeshBuild build_half_edge_mesh(std::span<const Vec3> vertices, std::span<const Triangle> triangles);

/// **L2.5** The plane of a polygon by Newell's method, which is robust against short edges,
/// collinear corners and reflex vertices. The plane contains the mean of the corners. Newell,
/// Newell & Sancha (1972); Ericson §12.4.2.
/// @param corners at least three, counter-clockwise seen from the side that the normal points to;
///   any frame (m)
Plane polygon_plane(std::span<const Vec3> corners);

/// **L2.5** The plane of a face: polygon_plane() of its corners, in the order of its loop.
Plane face_plane(const HalfEdgeMesh& mesh, Index face);

/// Given: a copy of a mesh without its removed elements. A half-edge is removed if its `face` is
/// no_index, a face if its `edge` is no_index, a vertex if no remaining half-edge points to it.
/// Both halves of a removed edge must be marked. The remaining elements keep their order and planes
/// and are renumbered; vertex_edge is recomputed. A link to a removed element becomes no_index,
/// which validate() reports.
HalfEdgeMesh without_removed(const HalfEdgeMesh& mesh);

/// The default tolerance of merge_coplanar_faces(), relative to the size of the mesh.
inline constexpr Real coplanar_tolerance = Real(1e-5);

/// **L2.6**–**L2.9** Merges coplanar neighbours into convex polygons. This matters in lab 5: a
/// triangular reference face would clip away half of a box's contact polygon.
///
/// - L2.6: two faces are merged only if the *merged* face is valid: all its vertices lie within
///   tolerance·size of its Newell plane (nearly coplanar is not transitive), no vertex of the mesh is
///   farther than that in front of it, and its outline is convex, up to dents: of two edges in a row
///   the longer may end 4·tolerance·size outside the line of the shorter.
/// - L2.7: a vertex that is left with only two edges is removed from both of its faces. Nothing is
///   merged if one of them would not be valid without it, or if the vertex is farther than
///   4·tolerance·size from the line through the nearest remaining vertices before and after it.
/// - L2.8: if the union of two faces has a reflex vertex, the coplanar faces behind that vertex are
///   included, so that a flat face becomes one polygon however it was triangulated. A chain of shared
///   edges is removed as a whole, with its inner vertices.
/// - L2.9: the order of the triangles does not matter, and merging the result changes nothing: passes
///   over the edges are repeated, each on the renumbered mesh that the last one left, until one
///   merges nothing. Vertices that are removed count as vertices of the mesh until their pass ends.
///
/// Unused vertices are removed; the rest keep their order.
/// @param tolerance relative to the largest extent of the mesh's bounds
HalfEdgeMesh merge_coplanar_faces(const HalfEdgeMesh& mesh, Real tolerance = coplanar_tolerance);

}  // namespace cs550
