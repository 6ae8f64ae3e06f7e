#pragma once
/// @file solids.hpp
/// Solids with known dimensions, as polygons, and ways to cut them into triangles.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cs550/primitives.hpp"
#include "helpers/random.hpp"

namespace cs550::test {

/// Polygons, counter-clockwise seen from outside.
struct Solid {
  std::vector<Vec3> vertices;
  std::vector<std::vector<Index>> polygons;
};

/// The box |x| ≤ a, |y| ≤ b, |z| ≤ c.
inline Solid box(const Vec3& half_extents) {
  Solid solid;
  for (const Real z : {-1, 1}) {
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      solid.vertices.push_back(Vec3(Real(x), Real(y), z).cwiseProduct(half_extents));
    }
  }
  solid.polygons = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4},
                    {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return solid;
}

/// The regular dodecahedron with vertices on the sphere of radius √3: (±1, ±1, ±1) and the cyclic
/// turns of (0, ±1/φ, ±φ). The directions of its faces are the cyclic turns of (0, ±φ, ±1).
inline Solid dodecahedron() {
  const Real phi = (1 + std::sqrt(Real(5))) / 2;
  Solid solid;
  std::vector<Vec3> directions;
  for (const Real s : {-1, 1}) {
    for (const Real t : {-1, 1}) {
      for (const Real u : {-1, 1}) solid.vertices.emplace_back(s, t, u);
      solid.vertices.insert(solid.vertices.end(),
                            {{0, s / phi, t * phi}, {t * phi, 0, s / phi}, {s / phi, t * phi, 0}});
      directions.insert(directions.end(), {{0, s * phi, t}, {t, 0, s * phi}, {s * phi, t, 0}});
    }
  }
  for (const Vec3& direction : directions) {
    const Vec3 normal = direction.normalized();
    const Vec3 u = any_perpendicular(normal);
    const Vec3 v = normal.cross(u);
    std::vector<std::pair<Real, Index>> by_angle;
    for (Index i = 0; i < static_cast<Index>(solid.vertices.size()); ++i) {
      const Vec3& point = solid.vertices[i];
      // The five vertices of a face are at φ²/√(φ² + 1) = 1.376 along its normal, the next at 0.85.
      if (normal.dot(point) > Real(1.2)) {
        by_angle.emplace_back(std::atan2(v.dot(point), u.dot(point)), i);
      }
    }
    std::sort(by_angle.begin(), by_angle.end());
    std::vector<Index> pentagon;
    pentagon.reserve(by_angle.size());
    for (const auto& entry : by_angle) pentagon.push_back(entry.second);
    solid.polygons.push_back(pentagon);
  }
  return solid;
}

/// Every polygon as a fan from its first corner.
inline TriangleSoup cut_from_corners(const Solid& solid) {
  TriangleSoup soup{solid.vertices, {}};
  for (const std::vector<Index>& polygon : solid.polygons) {
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      soup.triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
    }
  }
  return soup;
}

/// Every polygon as a fan around its centre, which becomes a vertex.
inline TriangleSoup cut_from_centres(const Solid& solid) {
  TriangleSoup soup{solid.vertices, {}};
  for (const std::vector<Index>& polygon : solid.polygons) {
    const Index centre = static_cast<Index>(soup.vertices.size());
    Vec3 sum = Vec3::Zero();
    for (const Index v : polygon) sum += solid.vertices[v];
    soup.vertices.push_back(sum / static_cast<Real>(polygon.size()));
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      soup.triangles.push_back({polygon[i], polygon[(i + 1) % polygon.size()], centre});
    }
  }
  return soup;
}

/// Scaled, turned, then shifted.
inline TriangleSoup placed(TriangleSoup soup, Real scale, const Quat& turn, const Vec3& shift) {
  for (Vec3& vertex : soup.vertices) vertex = turn * (scale * vertex) + shift;
  return soup;
}

/// The same triangles in another order.
inline TriangleSoup shuffled(TriangleSoup soup, Random& random) {
  for (int i = static_cast<int>(soup.triangles.size()) - 1; i > 0; --i) {
    std::swap(soup.triangles[i], soup.triangles[random.integer(0, i)]);
  }
  return soup;
}

}  // namespace cs550::test
