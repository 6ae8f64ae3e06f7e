#include "drawing/minkowski_drawing.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "cs550/primitives.hpp"

namespace cs550::drawing {
namespace {

/// The tolerance for points on a plane, relative to the sizes of the bodies.
constexpr Real relative_tolerance = Real(1e-4);

/// The differences of all vertices of A and all vertices of B, in the world frame.
std::vector<Vec3> vertex_differences(const PosedShape& a, const PosedShape& b) {
  std::vector<Vec3> differences;
  for (Index i = 0; i < a.mesh().vertex_count(); ++i) {
    for (Index k = 0; k < b.mesh().vertex_count(); ++k) {
      differences.emplace_back(a.vertex(i) - b.vertex(k));
    }
  }
  return differences;
}

Real highest(const std::vector<Vec3>& points, const Vec3& direction) {
  Real result = -HUGE_VALF;
  for (const Vec3& point : points) result = std::max(result, point.dot(direction));
  return result;
}

std::vector<Vec3> extreme(const std::vector<Vec3>& points, const Vec3& direction, Real tolerance) {
  const Real least = highest(points, direction) - tolerance;
  std::vector<Vec3> result;
  std::copy_if(points.begin(), points.end(), std::back_inserter(result),
               [&](const Vec3& point) { return point.dot(direction) >= least; });
  return result;
}

/// The convex hull of points of a plane, counter-clockwise about its normal (Andrew 1979).
std::vector<Vec3> planar_hull(const std::vector<Vec3>& points, const Vec3& normal, Real tolerance) {
  if (points.size() < 3) return points;
  const Vec3 u = any_perpendicular(normal);
  const Vec3 v = normal.cross(u);
  std::vector<std::pair<Vec2, Vec3>> flat;
  flat.reserve(points.size());
  for (const Vec3& point : points) flat.push_back({{point.dot(u), point.dot(v)}, point});
  std::sort(flat.begin(), flat.end(), [](const auto& a, const auto& b) {
    return a.first.x() < b.first.x() || (a.first.x() == b.first.x() && a.first.y() < b.first.y());
  });
  std::vector<std::pair<Vec2, Vec3>> hull;
  const auto grow = [&](const std::pair<Vec2, Vec3>& next, std::size_t least) {
    const auto turns_left = [&] {
      const Vec2 before = hull.back().first - hull[hull.size() - 2].first;
      const Vec2 after = next.first - hull.back().first;
      return before.x() * after.y() - before.y() * after.x() > tolerance * tolerance;
    };
    while (hull.size() >= least && !turns_left()) hull.pop_back();
    hull.push_back(next);
  };
  for (const auto& point : flat) grow(point, 2);
  const std::size_t lower = hull.size() + 1;
  for (std::size_t i = flat.size() - 1; i-- > 0;) grow(flat[i], lower);
  hull.pop_back();
  std::vector<Vec3> corners;
  corners.reserve(hull.size());
  for (const auto& [place, corner] : hull) corners.push_back(corner);
  return corners;
}

/// The planes of a hull's faces, without duplicates from triangles of the same face. Large
/// triangles come first, because a sliver has no reliable normal.
std::vector<Plane> face_planes(const TriangleSoup& hull, Real tolerance) {
  struct HullTriangle {
    std::array<Vec3, 3> corners;
    Vec3 twice_area;
  };
  std::vector<HullTriangle> triangles;
  for (const Triangle& triangle : hull.triangles) {
    const Vec3& p = hull.vertices[triangle[0]];
    const Vec3& q = hull.vertices[triangle[1]];
    const Vec3& r = hull.vertices[triangle[2]];
    triangles.push_back({{p, q, r}, (q - p).cross(r - p)});
  }
  std::stable_sort(triangles.begin(), triangles.end(), [](const auto& a, const auto& b) {
    return a.twice_area.squaredNorm() > b.twice_area.squaredNorm();
  });
  std::vector<Plane> planes;
  for (const HullTriangle& triangle : triangles) {
    const bool is_known = std::any_of(planes.begin(), planes.end(), [&](const Plane& plane) {
      return std::all_of(triangle.corners.begin(), triangle.corners.end(), [&](const Vec3& corner) {
        return std::abs(plane.distance(corner)) < tolerance;
      });
    });
    if (is_known || triangle.twice_area.norm() == 0) continue;
    const Vec3 normal = triangle.twice_area.normalized();
    planes.push_back({normal, normal.dot(triangle.corners[0])});
  }
  return planes;
}

/// Whether a body has a face with this normal, except for rounding.
bool has_normal(const PosedShape& body, const Vec3& normal) {
  constexpr Real same_direction = Real(1) - Real(1e-6);
  for (Index f = 0; f < body.mesh().face_count(); ++f) {
    if (body.plane(f).normal.dot(normal) > same_direction) return true;
  }
  return false;
}

/// The origin of a face of A − B: a face of A, a face of −B, or an edge pair.
Role owner_of(const Vec3& normal, const PosedShape& a, const PosedShape& b) {
  if (has_normal(a, normal)) return Role::BodyA;
  if (has_normal(b, -normal)) return Role::BodyB;
  return Role::Incident;
}

}  // namespace

Drawing draw_minkowski_difference(const PosedShape& a, const PosedShape& b) {
  Drawing drawing;
  drawing.title = "Minkowski difference A − B";
  const Real tolerance = relative_tolerance * (a.shape->radius + b.shape->radius);
  const TriangleSoup hull = convex_hull(vertex_differences(a, b)).soup;

  bool holds_origin = true;
  for (const Plane& plane : face_planes(hull, tolerance)) {
    const std::vector<Vec3> points = extreme(hull.vertices, plane.normal, tolerance);
    Polygon polygon{planar_hull(points, plane.normal, tolerance), owner_of(plane.normal, a, b),
                    Real(0.6)};
    if (polygon.corners.size() < 3) continue;
    holds_origin = holds_origin && plane.offset >= 0;
    add_closed_curve(drawing, polygon.corners, {Role::Axis, Real(1.1)});
    drawing.polygons.push_back(std::move(polygon));
  }
  drawing.points.push_back({Vec3::Zero(), Role::Highlight, 6});
  drawing.labels.push_back({Vec3::Zero(), "origin", Role::Text});
  drawing.alt_text = "The Minkowski difference of A and B has " +
                     std::to_string(drawing.polygons.size()) + " faces; the origin is " +
                     (holds_origin ? "inside: the bodies overlap." : "outside: they are apart.");
  drawing.legend = {{"face of A", {Role::BodyA, 2}, LegendMark::Patch},
                    {"face of −B", {Role::BodyB, 2}, LegendMark::Patch},
                    {"pair of edges", {Role::Incident, 2}, LegendMark::Patch}};
  return drawing;
}

}  // namespace cs550::drawing
