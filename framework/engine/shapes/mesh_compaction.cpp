#include <utility>

#include "cs550/half_edge_mesh.hpp"

namespace cs550 {
namespace {

/// From the numbers of elements to those that they get among the kept ones.
class NewNumbers {
 public:
  explicit NewNumbers(Index count) : numbers_(count, no_index) {}

  /// Marks an element as kept. An index of nothing is passed over.
  void keep(Index i) {
    if (is_known(i)) numbers_[i] = 0;
  }

  /// Numbers the kept elements in their order.
  void assign() {
    Index next = 0;
    for (Index& number : numbers_) {
      if (number != no_index) number = next++;
    }
  }

  /// no_index for what was removed or never was.
  Index operator[](Index i) const { return is_known(i) ? numbers_[i] : no_index; }

 private:
  bool is_known(Index i) const { return i >= 0 && std::cmp_less(i, numbers_.size()); }

  std::vector<Index> numbers_;
};

}  // namespace

HalfEdgeMesh without_removed(const HalfEdgeMesh& mesh) {
  NewNumbers edges(mesh.edge_count()), faces(mesh.face_count()), vertices(mesh.vertex_count());
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (mesh.edge(e).face == no_index) continue;
    edges.keep(e);
    edges.keep(e ^ 1);
    vertices.keep(mesh.edge(e).vertex);
  }
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).edge != no_index) faces.keep(f);
  }
  for (NewNumbers* numbers : {&edges, &faces, &vertices}) numbers->assign();

  HalfEdgeMesh result;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (vertices[v] != no_index) result.vertices.push_back(mesh.vertex(v));
  }
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Face& face = mesh.face(f);
    if (faces[f] != no_index) result.faces.push_back({edges[face.edge], face.plane});
  }
  result.vertex_edge.resize(result.vertices.size(), no_index);
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (edges[e] == no_index) continue;
    const HalfEdge& edge = mesh.edge(e);
    const HalfEdge renumbered = {.vertex = vertices[edge.vertex],
                                 .next = edges[edge.next],
                                 .prev = edges[edge.prev],
                                 .twin = edges[edge.twin],
                                 .face = faces[edge.face]};
    // Where one half-edge ends its twin begins.
    if (renumbered.vertex != no_index) {
      result.vertex_edge[renumbered.vertex] = edges[e ^ 1];
    }
    result.edges.push_back(renumbered);
  }
  return result;
}

}  // namespace cs550
