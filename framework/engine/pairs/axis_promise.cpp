#include "engine/pairs/axis_promise.hpp"

#include <cmath>

namespace cs550 {

namespace {

bool in_range(Index index, Index count) { return index >= 0 && index < count; }

bool in_range(const FaceQuery& query, const HalfEdgeMesh& faces_of,
              const HalfEdgeMesh& vertices_of) {
  return !query || (in_range(query.face, faces_of.face_count()) &&
                    in_range(query.vertex, vertices_of.vertex_count()));
}

}  // namespace

bool is_unit(const Vec3& v) { return std::abs(v.norm() - 1) < unit_tolerance; }

const char* broken_promise(const SeparatingAxis& axis, const HalfEdgeMesh& a,
                           const HalfEdgeMesh& b) {
  if (!std::isfinite(axis.separation)) return "the separation is not finite";
  if (!is_unit(axis.axis)) return "the axis is not a unit vector";
  if (!in_range(axis.face_a, a, b) || !in_range(axis.face_b, b, a)) {
    return "a face query names a face or vertex that does not exist";
  }
  if (axis.edges && (!in_range(axis.edges.edge_a, a.edge_count()) ||
                     !in_range(axis.edges.edge_b, b.edge_count()))) {
    return "the edge query names an edge that does not exist";
  }
  return nullptr;
}

}  // namespace cs550
