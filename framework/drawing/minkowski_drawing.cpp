#include "drawing/minkowski_drawing.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace cs550::drawing {
namespace {

/// Vertices this close to a supporting plane lie on it, relative to the sizes of the bodies.
constexpr Real relative_tolerance = Real(1e-4);
/// Normals whose cosine is above this are the same face.
constexpr Real same_normal = Real(1) - Real(1e-6);

std::vector<Vec3> world_vertices(const PosedShape& body) {
  std::vector<Vec3> vertices;
  vertices.reserve(body.mesh().vertices.size());
  for (Index v = 0; v < body.mesh().vertex_count(); ++v) vertices.push_back(body.vertex(v));
  return vertices;
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

struct FaceNormal {
  Vec3 normal;
  Role role;
};

/// The face normals of A − B: those of A and −B, and of pairs of edges that a plane can touch at
/// once.
std::vector<FaceNormal> face_normals(const PosedShape& a, const PosedShape& b,
                                     const std::vector<Vec3>& vertices_a,
                                     const std::vector<Vec3>& negated_b, Real tolerance) {
  std::vector<FaceNormal> normals;
  const auto add = [&](const Vec3& normal, Role role) {
    const bool is_new = std::none_of(normals.begin(), normals.end(), [&](const FaceNormal& other) {
      return other.normal.dot(normal) > same_normal;
    });
    if (is_new) normals.push_back({normal, role});
  };
  for (Index f = 0; f < a.mesh().face_count(); ++f) add(a.plane(f).normal, Role::BodyA);
  for (Index f = 0; f < b.mesh().face_count(); ++f) add(-b.plane(f).normal, Role::BodyB);
  for (Index e = 0; e < a.mesh().edge_count(); e += 2) {
    const Vec3 along_a = a.pose.rotate(a.mesh().edge_vector(e));
    const Vec3 on_a = a.vertex(a.mesh().edge(e).vertex);
    for (Index k = 0; k < b.mesh().edge_count(); k += 2) {
      const Vec3 cross = along_a.cross(b.pose.rotate(b.mesh().edge_vector(k)));
      if (!(cross.norm() > relative_tolerance * along_a.norm() * b.mesh().edge_vector(k).norm())) {
        continue;
      }
      const Vec3 on_b = b.vertex(b.mesh().edge(k).vertex);
      for (const Real sign : {Real(-1), Real(1)}) {
        const Vec3 normal = sign * cross.normalized();
        const bool supports = on_a.dot(normal) >= highest(vertices_a, normal) - tolerance &&
                              -on_b.dot(normal) >= highest(negated_b, normal) - tolerance;
        if (supports) add(normal, Role::Incident);
      }
    }
  }
  return normals;
}

}  // namespace

Drawing draw_minkowski_difference(const PosedShape& a, const PosedShape& b) {
  Drawing drawing;
  drawing.title = "Minkowski difference A − B";
  const std::vector<Vec3> vertices_a = world_vertices(a);
  std::vector<Vec3> negated_b = world_vertices(b);
  for (Vec3& vertex : negated_b) vertex = -vertex;
  const Real tolerance = relative_tolerance * (a.shape->radius + b.shape->radius);

  bool holds_origin = true;
  for (const FaceNormal& face : face_normals(a, b, vertices_a, negated_b, tolerance)) {
    std::vector<Vec3> sums;
    for (const Vec3& p : extreme(vertices_a, face.normal, tolerance)) {
      for (const Vec3& q : extreme(negated_b, face.normal, tolerance)) sums.emplace_back(p + q);
    }
    Polygon polygon{planar_hull(sums, face.normal, tolerance), face.role, Real(0.6)};
    if (polygon.corners.size() < 3) continue;
    holds_origin = holds_origin && polygon.corners.front().dot(face.normal) >= 0;
    add_closed_curve(drawing, polygon.corners, {Role::Axis, Real(1.1)});
    drawing.polygons.push_back(std::move(polygon));
  }
  drawing.points.push_back({Vec3::Zero(), Role::Highlight, 6});
  drawing.labels.push_back({Vec3::Zero(), "origin", Role::Text});
  drawing.alt_text = "The Minkowski difference of A and B has " +
                     std::to_string(drawing.polygons.size()) + " faces; the origin lies " +
                     (holds_origin ? "inside: the bodies overlap." : "outside: they are apart.");
  drawing.legend = {{"face of A", {Role::BodyA, 2}, LegendMark::Patch},
                    {"face of −B", {Role::BodyB, 2}, LegendMark::Patch},
                    {"pair of edges", {Role::Incident, 2}, LegendMark::Patch}};
  return drawing;
}

}  // namespace cs550::drawing
