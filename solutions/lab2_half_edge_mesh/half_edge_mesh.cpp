/// @file half_edge_mesh.cpp
/// Lab 2, reference, L2.1 to L2.5: from triangles to a closed mesh. L2.6 to L2.9 are in merging.cpp.

#include "cs550/half_edge_mesh.hpp"

#include <algorithm>
#include <tuple>

namespace cs550 {

namespace {

/// Twice the area of a triangle, over the square of its longest edge, up to which it has no area.
constexpr Real least_relative_area = Real(1e-7);

Index count_of(std::size_t size) { return static_cast<Index>(size); }

// ---------------------------------------------------------------- L2.1 the triangles themselves

bool is_degenerate(std::span<const Vec3> vertices, const Triangle& triangle) {
  const auto [i, j, k] = triangle;
  if (i == j || j == k || k == i) return true;
  const Vec3 ab = vertices[j] - vertices[i];
  const Vec3 bc = vertices[k] - vertices[j];
  const Vec3 ca = vertices[i] - vertices[k];
  const Real longest = std::max({ab.squaredNorm(), bc.squaredNorm(), ca.squaredNorm()});
  return ab.cross(bc).norm() <= least_relative_area * longest;
}

/// The first triangle, in the order of the list, whose vertices an earlier one has too.
MeshIssue find_duplicate(std::span<const Triangle> triangles) {
  std::vector<std::pair<Triangle, Index>> sorted;
  for (Index t = 0; t < count_of(triangles.size()); ++t) {
    Triangle key = triangles[t];
    std::sort(key.begin(), key.end());
    sorted.emplace_back(key, t);
  }
  std::sort(sorted.begin(), sorted.end());

  MeshIssue issue;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const bool is_equal = sorted[i - 1].first == sorted[i].first;
    if (is_equal && (!issue || sorted[i].second < issue.other_triangle)) {
      issue = {.error = MeshError::DuplicateTriangle,
               .triangle = sorted[i - 1].second,
               .other_triangle = sorted[i].second};
    }
  }
  return issue;
}

MeshIssue check_triangles(std::span<const Vec3> vertices, std::span<const Triangle> triangles) {
  if (triangles.empty()) return {.error = MeshError::NoTriangles};

  const Index vertex_count = count_of(vertices.size());
  for (Index v = 0; v < vertex_count; ++v) {
    if (!vertices[v].allFinite()) return {.error = MeshError::NonFiniteVertex, .vertex = v};
  }

  std::vector<bool> is_used(vertices.size(), false);
  for (Index t = 0; t < count_of(triangles.size()); ++t) {
    for (Index v : triangles[t]) {
      if (v < 0 || v >= vertex_count) {
        return {.error = MeshError::IndexOutOfRange, .triangle = t, .vertex = v};
      }
      is_used[v] = true;
    }
  }

  for (Index t = 0; t < count_of(triangles.size()); ++t) {
    if (is_degenerate(vertices, triangles[t])) {
      return {.error = MeshError::DegenerateTriangle, .triangle = t};
    }
  }

  if (const MeshIssue duplicate = find_duplicate(triangles)) return duplicate;

  const auto unused = std::find(is_used.begin(), is_used.end(), false);
  if (unused != is_used.end()) {
    return {.error = MeshError::IsolatedVertex,
            .vertex = static_cast<Index>(unused - is_used.begin())};
  }
  return {};
}

// ---------------------------------------------------------------- L2.2 edges and twins

/// One side of a triangle, from a to b. Sorted, the sides of one edge become neighbours.
struct Side {
  Index a, b;
  Index corner;  ///< 3·triangle + place in it

  Index low() const { return std::min(a, b); }
  Index high() const { return std::max(a, b); }
  Index triangle() const { return corner / 3; }
  bool shares_edge_with(const Side& other) const {
    return low() == other.low() && high() == other.high();
  }
  bool operator<(const Side& other) const {
    return std::tuple(low(), high(), a, corner) <
           std::tuple(other.low(), other.high(), other.a, other.corner);
  }
};

std::vector<Side> sorted_sides(std::span<const Triangle> triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (const Triangle& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      sides.push_back({triangle[i], triangle[(i + 1) % 3], count_of(sides.size())});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// Every edge needs exactly two sides, which run in opposite directions.
MeshIssue check_sides(const std::vector<Side>& sides) {
  MeshIssue non_manifold, inconsistent, open;
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].shares_edge_with(sides[first])) ++last;
    const Side& side = sides[first];
    MeshIssue here{.triangle = side.triangle(), .edge = {side.a, side.b}};
    if (last - first > 1) here.other_triangle = sides[first + 1].triangle();

    const auto keep_first = [&here](MeshIssue& issue, MeshError error) {
      if (issue) return;
      issue = here;
      issue.error = error;
    };
    if (last - first > 2) {
      keep_first(non_manifold, MeshError::NonManifoldEdge);
    } else if (last - first == 1) {
      keep_first(open, MeshError::OpenEdge);
    } else if (side.a == sides[first + 1].a) {
      keep_first(inconsistent, MeshError::InconsistentWinding);
    }
  }
  if (non_manifold) return non_manifold;
  return inconsistent ? inconsistent : open;
}

// ---------------------------------------------------------------- L2.3 links

/// Sorted sides of one edge are neighbours, so half-edge `e` is side `e` and its twin is `e ^ 1`.
HalfEdgeMesh link(std::span<const Vec3> vertices, const std::vector<Side>& sides) {
  HalfEdgeMesh mesh;
  mesh.vertices.assign(vertices.begin(), vertices.end());
  mesh.vertex_edge.assign(vertices.size(), no_index);
  mesh.edges.resize(sides.size());
  mesh.faces.resize(sides.size() / 3);

  std::vector<Index> edge_at(sides.size());  // the half-edge that starts at each corner
  for (Index e = 0; e < count_of(sides.size()); ++e) edge_at[sides[e].corner] = e;

  for (Index e = 0; e < count_of(sides.size()); ++e) {
    const Side& side = sides[e];
    const Index face = side.triangle();
    const Index place = side.corner % 3;
    mesh.edges[e] = {.vertex = side.b,
                     .next = edge_at[3 * face + (place + 1) % 3],
                     .prev = edge_at[3 * face + (place + 2) % 3],
                     .twin = e ^ 1,
                     .face = face};
    mesh.vertex_edge[side.a] = e;
    if (place == 0) mesh.faces[face].edge = e;
  }
  return mesh;
}

// ---------------------------------------------------------------- L2.4 inside and outside

/// Six times the signed volume: the sum of the tetrahedra that the triangles span with one vertex.
double six_volumes(std::span<const Vec3> vertices, std::span<const Triangle> triangles) {
  const Vec3& apex = vertices.front();
  double sum = 0;
  for (const auto& [i, j, k] : triangles) {
    const Vec3 a = vertices[i] - apex, b = vertices[j] - apex, c = vertices[k] - apex;
    sum += double(a.dot(b.cross(c)));
  }
  return sum;
}

}  // namespace

MeshBuild build_half_edge_mesh(std::span<const Vec3> vertices,
                               std::span<const Triangle> triangles) {
  if (const MeshIssue issue = check_triangles(vertices, triangles)) return {{}, issue};

  const std::vector<Side> sides = sorted_sides(triangles);
  if (const MeshIssue issue = check_sides(sides)) return {{}, issue};

  HalfEdgeMesh mesh = link(vertices, sides);
  for (Index f = 0; f < mesh.face_count(); ++f) mesh.faces[f].plane = face_plane(mesh, f);
  if (six_volumes(vertices, triangles) < 0) return {{}, {.error = MeshError::InsideOut}};
  return {std::move(mesh), {}};
}

Plane polygon_plane(std::span<const Vec3> corners) {
  // Relative to a corner, so that a body far from the origin loses no digits.
  Vec3 centroid = Vec3::Zero();
  for (const Vec3& corner : corners) centroid += corner - corners.front();
  centroid = corners.front() + centroid / Real(corners.size());

  Vec3 normal = Vec3::Zero();
  Vec3 a = corners.back() - centroid;
  for (const Vec3& corner : corners) {
    const Vec3 b = corner - centroid;
    normal += a.cross(b);
    a = b;
  }
  normal.normalize();
  return {normal, normal.dot(centroid)};
}

Plane face_plane(const HalfEdgeMesh& mesh, Index face) {
  std::vector<Vec3> corners;
  for (Index e : face_edges(mesh, face)) corners.push_back(mesh.vertex(mesh.origin(e)));
  return polygon_plane(corners);
}

}  // namespace cs550
