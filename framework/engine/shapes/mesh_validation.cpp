#include "cs550/mesh_validation.hpp"

#include <locale>
#include <sstream>

#include "cs550/mass_properties.hpp"

namespace cs550 {
namespace {

using Defect = std::optional<MeshDefect>;

const char* name(MeshElement element) {
  switch (element) {
    case MeshElement::Mesh:
      return "mesh";
    case MeshElement::Vertex:
      return "vertex";
    case MeshElement::HalfEdge:
      return "half-edge";
    case MeshElement::Face:
      return "face";
  }
  return "element";
}

template <class... Parts>
Defect defect(MeshElement element, Index index, const Parts&... parts) {
  std::ostringstream sentence;
  sentence.imbue(std::locale::classic());
  sentence << name(element);
  if (index != no_index) sentence << ' ' << index;
  sentence << ": ";
  (sentence << ... << parts);
  return MeshDefect{element, index, sentence.str()};
}

/// What a check looks at.
struct Subject {
  const HalfEdgeMesh& mesh;
  Real allowed_distance;  ///< for planarity and convexity (m)
};

bool is_element(Index i, Index count) { return i >= 0 && i < count; }

Defect sizes_and_ranges(const Subject& subject) {
  const HalfEdgeMesh& mesh = subject.mesh;
  const Index vertices = mesh.vertex_count();
  const Index edges = mesh.edge_count();
  const Index faces = mesh.face_count();
  if (vertices == 0 || edges == 0 || faces == 0) {
    return defect(MeshElement::Mesh, no_index, "it has no vertices, half-edges or faces");
  }
  if (edges % 2 != 0) {
    return defect(MeshElement::Mesh, no_index, "it has ", edges,
                  " half-edges, an odd number: one has no twin");
  }
  if (mesh.vertex_edge.size() != mesh.vertices.size()) {
    return defect(MeshElement::Mesh, no_index, "vertex_edge has ", mesh.vertex_edge.size(),
                  " entries for ", vertices, " vertices");
  }
  for (Index v = 0; v < vertices; ++v) {
    const Index e = mesh.vertex_edge[v];
    if (!is_element(e, edges)) {
      return defect(MeshElement::Vertex, v, "its half-edge ", e, " does not exist");
    }
  }
  for (Index e = 0; e < edges; ++e) {
    const HalfEdge& edge = mesh.edge(e);
    if (!is_element(edge.vertex, vertices)) {
      return defect(MeshElement::HalfEdge, e, "its vertex ", edge.vertex, " does not exist");
    }
    if (!is_element(edge.next, edges)) {
      return defect(MeshElement::HalfEdge, e, "its next ", edge.next, " does not exist");
    }
    if (!is_element(edge.prev, edges)) {
      return defect(MeshElement::HalfEdge, e, "its prev ", edge.prev, " does not exist");
    }
    if (!is_element(edge.twin, edges)) {
      return defect(MeshElement::HalfEdge, e, "its twin ", edge.twin, " does not exist");
    }
    if (!is_element(edge.face, faces)) {
      return defect(MeshElement::HalfEdge, e, "its face ", edge.face, " does not exist");
    }
  }
  for (Index f = 0; f < faces; ++f) {
    if (!is_element(mesh.face(f).edge, edges)) {
      return defect(MeshElement::Face, f, "its half-edge ", mesh.face(f).edge, " does not exist");
    }
  }
  return std::nullopt;
}

Defect finite_vertices(const Subject& subject) {
  for (Index v = 0; v < subject.mesh.vertex_count(); ++v) {
    if (!subject.mesh.vertex(v).allFinite()) {
      return defect(MeshElement::Vertex, v, "a coordinate is infinite or not a number");
    }
  }
  return std::nullopt;
}

Defect twins(const Subject& subject) {
  const HalfEdgeMesh& mesh = subject.mesh;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index twin = mesh.edge(e).twin;
    if (mesh.edge(twin).twin != e) {
      return defect(MeshElement::HalfEdge, e, "its twin ", twin, " does not point back to it");
    }
    if (twin != (e ^ 1)) {
      return defect(MeshElement::HalfEdge, e, "its twin is ", twin, ", not its neighbour ", e ^ 1);
    }
    if (mesh.edge(twin).vertex == mesh.edge(e).vertex) {
      return defect(MeshElement::HalfEdge, e, "it and its twin ", twin,
                    " point to the same vertex ", mesh.edge(e).vertex);
    }
    if (mesh.vertex(mesh.edge(e).vertex) == mesh.vertex(mesh.origin(e))) {
      return defect(MeshElement::HalfEdge, e, "its ends are in one place; make them one vertex");
    }
  }
  return std::nullopt;
}

Defect loops(const Subject& subject) {
  const HalfEdgeMesh& mesh = subject.mesh;
  std::vector<Index> edges_of_face(mesh.faces.size(), 0);
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index next = mesh.edge(e).next;
    if (mesh.edge(next).prev != e) {
      return defect(MeshElement::HalfEdge, e, "the prev of its next ", next, " is ",
                    mesh.edge(next).prev);
    }
    if (mesh.edge(next).face != mesh.edge(e).face) {
      return defect(MeshElement::HalfEdge, e, "it belongs to face ", mesh.edge(e).face,
                    " and its next ", next, " to face ", mesh.edge(next).face);
    }
    if (mesh.origin(next) != mesh.edge(e).vertex) {
      return defect(MeshElement::HalfEdge, e, "it points to vertex ", mesh.edge(e).vertex,
                    " and its next ", next, " leaves vertex ", mesh.origin(next));
    }
    ++edges_of_face[mesh.edge(e).face];
  }
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (mesh.edge(mesh.face(f).edge).face != f) {
      return defect(MeshElement::Face, f, "its half-edge ", mesh.face(f).edge, " belongs to face ",
                    mesh.edge(mesh.face(f).edge).face);
    }
    Index length = 0;
    for ([[maybe_unused]] Index e : face_edges(mesh, f)) ++length;
    if (length < 3) {
      return defect(MeshElement::Face, f, "it has only ", length, " edges");
    }
    if (length != edges_of_face[f]) {
      return defect(MeshElement::Face, f, "its edges form more than one loop");
    }
  }
  return std::nullopt;
}

Defect vertex_edges_leave(const Subject& subject) {
  const HalfEdgeMesh& mesh = subject.mesh;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Index e = mesh.vertex_edge[v];
    if (mesh.origin(e) != v) {
      return defect(MeshElement::Vertex, v, "its half-edge ", e, " leaves vertex ", mesh.origin(e));
    }
  }
  return std::nullopt;
}

/// One fan of at least three faces around each vertex.
Defect fans(const Subject& subject) {
  const HalfEdgeMesh& mesh = subject.mesh;
  std::vector<Index> edges_from(mesh.vertices.size(), 0);
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    ++edges_from[mesh.origin(e)];
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    Index degree = 0;
    for ([[maybe_unused]] Index e : vertex_edges(mesh, v)) ++degree;
    if (degree < 3) {
      return defect(MeshElement::Vertex, v, "it has only ", degree, " edges");
    }
    if (degree != edges_from[v]) {
      return defect(MeshElement::Vertex, v, "the surface touches itself there");
    }
  }
  return std::nullopt;
}

Defect euler(const Subject& subject) {
  const HalfEdgeMesh& mesh = subject.mesh;
  const Index edges = mesh.edge_count() / 2;
  const Index sum = mesh.vertex_count() - edges + mesh.face_count();
  if (sum == 2) return std::nullopt;
  return defect(MeshElement::Mesh, no_index, "V − E + F = ", mesh.vertex_count(), " − ", edges,
                " + ", mesh.face_count(), " = ", sum, ", not 2: it is not one closed surface");
}

Defect unit_normals(const Subject& subject) {
  const Real rounding = Real(1e-5);
  for (Index f = 0; f < subject.mesh.face_count(); ++f) {
    const Real length = subject.mesh.face(f).plane.normal.norm();
    if (!(std::abs(length - 1) < rounding)) {
      return defect(MeshElement::Face, f, "its normal has length ", length, ", not 1");
    }
  }
  return std::nullopt;
}

Defect planar_faces(const Subject& subject) {
  const HalfEdgeMesh& mesh = subject.mesh;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (Index e : face_edges(mesh, f)) {
      const Index v = mesh.edge(e).vertex;
      const Real distance = mesh.face(f).plane.distance(mesh.vertex(v));
      if (!(std::abs(distance) <= subject.allowed_distance)) {
        return defect(MeshElement::Face, f, "its vertex ", v, " is ", distance,
                      " m away from its plane");
      }
    }
  }
  return std::nullopt;
}

Defect positive_volume(const Subject& subject) {
  const Real volume = mass_properties(subject.mesh).volume;
  if (volume > 0) return std::nullopt;
  return defect(MeshElement::Mesh, no_index, "its volume is ", volume,
                " m³: faces are clockwise seen from outside");
}

/// Every corner of every face turns left, seen from outside.
Defect convex_faces(const Subject& subject) {
  const HalfEdgeMesh& mesh = subject.mesh;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (Index e : face_edges(mesh, f)) {
      const HalfEdge& edge = mesh.edge(e);
      const Vec3 inward = mesh.face(f).plane.normal.cross(mesh.edge_vector(e)).normalized();
      if (inward.dot(mesh.edge_vector(edge.next)) < -subject.allowed_distance) {
        return defect(MeshElement::Face, f, "its corner at vertex ", edge.vertex,
                      " turns inward: it is not convex");
      }
    }
  }
  return std::nullopt;
}

Defect convex_mesh(const Subject& subject) {
  const HalfEdgeMesh& mesh = subject.mesh;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const Real distance = mesh.face(f).plane.distance(mesh.vertex(v));
      if (distance > subject.allowed_distance) {
        return defect(MeshElement::Face, f, "vertex ", v, " lies ", distance,
                      " m in front of it: the mesh is not convex");
      }
    }
  }
  return std::nullopt;
}

Real largest_extent(const HalfEdgeMesh& mesh) {
  Bounds bounds;
  for (const Vec3& vertex : mesh.vertices) bounds.include(vertex);
  return bounds.extent().maxCoeff();
}

}  // namespace

std::optional<MeshDefect> validate(const HalfEdgeMesh& mesh, Real tolerance) {
  const Subject subject{mesh, tolerance * largest_extent(mesh)};
  // Each check relies on what those before it have found to be true.
  for (const auto check :
       {sizes_and_ranges, finite_vertices, twins, loops, vertex_edges_leave, fans, euler,
        unit_normals, planar_faces, positive_volume, convex_faces, convex_mesh}) {
    if (Defect found = check(subject)) return found;
  }
  return std::nullopt;
}

}  // namespace cs550
