/// @file merging.cpp
/// Lab 2, reference, L2.6 to L2.9: coplanar triangles become convex polygons.

#include <algorithm>
#include <optional>
#include <tuple>

#include "cs550/half_edge_mesh.hpp"

namespace cs550 {

namespace {

/// Dents are measured along the longer edge, which magnifies the error of a short one: so much more
/// than the distance of a vertex from a plane is let pass.
constexpr Real dent_slack = 4;

/// The half-edges around a face or around several that are to become one, counter-clockwise.
using Outline = std::vector<Index>;

Outline outline_of(const HalfEdgeMesh& mesh, Index face) {
  Outline outline;
  for (Index e : face_edges(mesh, face)) outline.push_back(e);
  return outline;
}

/// Replaces a half-edge of the outline by the way round the face behind it. Where the outline then
/// runs along an edge and straight back, it did so along a chain of shared edges: they go.
void absorb_face_behind(Index shared_edge, const HalfEdgeMesh& mesh, Outline& outline) {
  std::rotate(outline.begin(), std::find(outline.begin(), outline.end(), shared_edge) + 1,
              outline.end());
  outline.pop_back();
  const Index twin = mesh.edge(shared_edge).twin;
  for (Index e = mesh.edge(twin).next; e != twin; e = mesh.edge(e).next) {
    if (!outline.empty() && outline.back() == mesh.edge(e).twin) {
      outline.pop_back();
    } else {
      outline.push_back(e);
    }
  }
  while (outline.size() > 1 && outline.front() == mesh.edge(outline.back()).twin) {
    outline.pop_back();
    outline.erase(outline.begin());
  }
}

/// Faces that are to become one.
struct Union {
  Outline outline;
  std::vector<Index> faces;

  bool contains(Index face) const {
    return std::find(faces.begin(), faces.end(), face) != faces.end();
  }
};

/// One pass over the edges of a mesh.
class CoplanarMerger {
 public:
  CoplanarMerger(const HalfEdgeMesh& mesh, Real tolerance) : mesh_(mesh) {
    Bounds bounds;
    for (const Vec3& vertex : mesh.vertices) bounds.include(vertex);
    slack_ = tolerance * bounds.extent().maxCoeff();
  }

  HalfEdgeMesh run() {
    for (Index e : edges_flattest_first()) {
      if (is_removed(e)) continue;
      if (const std::optional<Union> merged = grow_across(e)) try_merge(*merged);
    }
    return finished();
  }

 private:
  bool is_removed(Index e) const { return mesh_.edge(e).face == no_index; }

  /// Geometry alone decides the order, so that the numbering of triangles cannot change the result.
  std::vector<Index> edges_flattest_first() const {
    std::vector<std::tuple<Real, Index, Index, Index>> keyed;
    for (Index e = 0; e < mesh_.edge_count(); e += 2) {
      const Vec3& left = mesh_.face(mesh_.edge(e).face).plane.normal;
      const Vec3& right = mesh_.face(mesh_.edge(e ^ 1).face).plane.normal;
      const auto [low, high] = std::minmax({mesh_.edge(e).vertex, mesh_.origin(e)});
      keyed.emplace_back((left - right).squaredNorm(), low, high, e);
    }
    std::sort(keyed.begin(), keyed.end());
    std::vector<Index> edges;
    edges.reserve(keyed.size());
    for (const auto& key : keyed) edges.push_back(std::get<3>(key));
    return edges;
  }

  /// The corners of an outline, from its lowest vertex on: the same outline gives the same bits.
  std::vector<Vec3> corners(const Outline& outline, const std::vector<Index>& without = {}) const {
    std::vector<Index> loop;
    for (Index e : outline) {
      const Index v = mesh_.origin(e);
      if (std::find(without.begin(), without.end(), v) == without.end()) loop.push_back(v);
    }
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    std::vector<Vec3> points;
    points.reserve(loop.size());
    for (Index v : loop) points.push_back(mesh_.vertex(v));
    return points;
  }

  bool is_flat(const std::vector<Vec3>& polygon, const Plane& plane) const {
    return std::all_of(polygon.begin(), polygon.end(), [&](const Vec3& point) {
      return std::abs(plane.distance(point)) <= slack_;
    });
  }

  /// Whether a polygon turns inward at b, between its neighbours a and c: the longer of the two edges
  /// ends well outside the line of the shorter.
  bool is_dent(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) const {
    const Vec3 in = b - a;
    const Vec3 out = c - b;
    const Real shorter = std::min(in.norm(), out.norm());
    return normal.dot(out.cross(in)) > dent_slack * slack_ * shorter;
  }

  /// Whether a polygon may be a face: flat, convex, and with all other vertices behind it.
  bool is_face(const std::vector<Vec3>& polygon) const {
    const std::size_t n = polygon.size();
    if (n < 3) return false;
    const Plane plane = polygon_plane(polygon);
    if (!is_flat(polygon, plane)) return false;
    for (std::size_t i = 0; i < n; ++i) {
      if (is_dent(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n], plane.normal)) {
        return false;
      }
    }
    return std::all_of(mesh_.vertices.begin(), mesh_.vertices.end(),
                       [&](const Vec3& vertex) { return plane.distance(vertex) <= slack_; });
  }

  /// A half-edge of the outline at a reflex vertex, with a face behind it that can fill the gap.
  Index edge_at_reflex_vertex(const Union& merged, const Vec3& normal) const {
    const std::size_t n = merged.outline.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Index in = merged.outline[i], out = merged.outline[(i + 1) % n];
      if (!is_dent(mesh_.vertex(mesh_.origin(in)), mesh_.vertex(mesh_.origin(out)),
                   mesh_.vertex(mesh_.edge(out).vertex), normal)) {
        continue;
      }
      for (Index e : {in, out}) {
        if (!merged.contains(mesh_.edge(mesh_.edge(e).twin).face)) return e;
      }
    }
    return no_index;
  }

  /// The two faces at an edge, and those needed to resolve the reflex vertices of their outline: of a triangle
  /// cut into a fan of three, no two faces are convex together. Nothing if that is not flat.
  std::optional<Union> grow_across(Index e) const {
    Union merged{outline_of(mesh_, mesh_.edge(e).face), {mesh_.edge(e).face}};
    for (Index shared_edge = e; shared_edge != no_index;) {
      const Index face = mesh_.edge(mesh_.edge(shared_edge).twin).face;
      absorb_face_behind(shared_edge, mesh_, merged.outline);
      merged.faces.push_back(face);
      if (merged.outline.size() < 3) return std::nullopt;

      const std::vector<Vec3> polygon = corners(merged.outline);
      const Plane plane = polygon_plane(polygon);
      const bool looks_one_way =
          std::all_of(merged.faces.begin(), merged.faces.end(),
                      [&](Index f) { return mesh_.face(f).plane.normal.dot(plane.normal) > 0; });
      if (!looks_one_way || !is_flat(polygon, plane)) return std::nullopt;
      shared_edge = edge_at_reflex_vertex(merged, plane.normal);
    }
    return merged;
  }

  /// The half-edges of an outline that leave a vertex which only two faces are left to share.
  std::vector<Index> edges_after_straight_vertices(const Outline& outline) const {
    std::vector<Index> result;
    Index in = outline.back();
    for (Index out : outline) {
      if (mesh_.edge(mesh_.edge(out).twin).next == mesh_.edge(in).twin) result.push_back(out);
      in = out;
    }
    return result;
  }

  /// Whether a removed vertex, at the end of a half-edge, is near the line between the nearest vertices
  /// that are kept. Where its two faces enclose a small angle, a corner is near both planes, too.
  bool is_straight(Index in, const std::vector<Index>& removed) const {
    const auto is_kept = [&](Index v) {
      return std::find(removed.begin(), removed.end(), v) == removed.end();
    };
    Index first = in;
    Index last = mesh_.edge(in).next;
    while (!is_kept(mesh_.origin(first))) first = mesh_.edge(first).prev;
    while (!is_kept(mesh_.edge(last).vertex)) last = mesh_.edge(last).next;
    const Vec3& start = mesh_.vertex(mesh_.origin(first));
    const Vec3 along = mesh_.vertex(mesh_.edge(last).vertex) - start;
    const Vec3 offset = mesh_.vertex(mesh_.edge(in).vertex) - start;
    return along.cross(offset).norm() <= dent_slack * slack_ * along.norm();
  }

  /// Merges if all faces that change are faces still, the united one and its neighbours at the
  /// vertices that go, and if these vertices are not corners.
  void try_merge(const Union& merged) {
    const std::vector<Index> straight = edges_after_straight_vertices(merged.outline);
    std::vector<Index> vertices;
    vertices.reserve(straight.size());
    for (Index e : straight) vertices.push_back(mesh_.origin(e));

    if (!is_face(corners(merged.outline, vertices))) return;
    for (Index e : straight) {
      const Index twin = mesh_.edge(e).twin;
      if (!is_face(corners(outline_of(mesh_, mesh_.edge(twin).face), vertices))) return;
      if (!is_straight(twin, vertices)) return;
    }
    unite(merged);
    for (Index e : straight) remove_origin(e);
  }

  /// Links the outline into the loop of one face; what it does not use is removed.
  void unite(const Union& merged) {
    for (Index f : merged.faces) {
      for (Index e : outline_of(mesh_, f)) mesh_.edges[e].face = no_index;
      mesh_.faces[f].edge = no_index;
    }
    const Index face = *std::min_element(merged.faces.begin(), merged.faces.end());
    Index prev = merged.outline.back();
    for (Index e : merged.outline) {
      mesh_.edges[e].face = face;
      mesh_.edges[e].prev = prev;
      mesh_.edges[prev].next = e;
      prev = e;
    }
    mesh_.faces[face].edge = prev;
  }

  /// Removes a vertex of degree two: the half-edges into it are lengthened past it.
  void remove_origin(Index out) {
    const Index in = mesh_.edge(out).prev;
    for (const auto& [kept, gone] : {std::pair(in, out), std::pair(in ^ 1, out ^ 1)}) {
      mesh_.faces[mesh_.edge(kept).face].edge = kept;
      mesh_.edges[gone].face = no_index;
    }
    mesh_.edges[in].vertex = mesh_.edge(out).vertex;
    mesh_.edges[in].next = mesh_.edge(out).next;
    mesh_.edges[mesh_.edge(out).next].prev = in;
    mesh_.edges[in ^ 1].prev = mesh_.edge(out ^ 1).prev;
    mesh_.edges[mesh_.edge(out ^ 1).prev].next = in ^ 1;
  }

  /// The mesh of what is left, with the planes that its faces now have.
  HalfEdgeMesh finished() const {
    HalfEdgeMesh result = without_removed(mesh_);
    for (Index f = 0; f < result.face_count(); ++f) {
      result.faces[f].edge = lowest_edge(result, f);
      result.faces[f].plane = face_plane(result, f);
    }
    return result;
  }

  /// The half-edge of a face from its lowest vertex: where a loop starts, whatever its history.
  static Index lowest_edge(const HalfEdgeMesh& mesh, Index face) {
    const Outline outline = outline_of(mesh, face);
    return *std::min_element(outline.begin(), outline.end(),
                             [&](Index a, Index b) { return mesh.origin(a) < mesh.origin(b); });
  }

  HalfEdgeMesh mesh_;  ///< keeps all vertices of the pass: the removed ones bound the error
  Real slack_;         ///< m
};

}  // namespace

HalfEdgeMesh merge_coplanar_faces(const HalfEdgeMesh& mesh, Real tolerance) {
  HalfEdgeMesh result = mesh;
  for (;;) {
    HalfEdgeMesh merged = CoplanarMerger(result, tolerance).run();
    if (merged.face_count() == result.face_count()) return result;
    result = std::move(merged);
  }
}

}  // namespace cs550
