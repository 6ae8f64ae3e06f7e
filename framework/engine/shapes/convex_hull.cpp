#include <libqhull_r/qhull_ra.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <locale>
#include <memory>
#include <sstream>

#include "cs550/primitives.hpp"

namespace cs550 {
namespace {

using Vec3d = Eigen::Vector3d;

/// A triangle is a sliver if its height is below this part of its longest edge: in float, its normal
/// would be mostly rounding.
constexpr double sliver_height = 1e-4;

std::string first_fault(std::span<const Vec3> points) {
  if (points.size() < 4) {
    return "a hull needs at least four points, there are " + std::to_string(points.size());
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) {
      return "point " + std::to_string(i) + " has a coordinate that is infinite or not a number";
    }
  }
  return {};
}

/// The distance of floats at the farthest coordinate of some points (m).
Real resolution_of(const Bounds& bounds) {
  return std::numeric_limits<Real>::epsilon() *
         std::max(bounds.lower.cwiseAbs().maxCoeff(), bounds.upper.cwiseAbs().maxCoeff());
}

/// Whether the points were rounded by more than a thousandth of their hull: it is another hull.
bool are_too_far(std::span<const Vec3> points) {
  constexpr Real tolerance = Real(1e-3);
  Bounds bounds;
  for (const Vec3& point : points) bounds.include(point);
  const Real size = bounds.extent().maxCoeff();
  return size > 0 && resolution_of(bounds) > tolerance * size;
}

/// What to do about points that are so far from the origin that a float no longer resolves their hull;
/// empty for others.
std::string advice_if_far(std::span<const Vec3> points) {
  Bounds bounds;
  for (const Vec3& point : points) bounds.include(point);
  const Real resolution = resolution_of(bounds);
  const Real distance = resolution / std::numeric_limits<Real>::epsilon();
  const Real size = bounds.extent().maxCoeff();
  if (resolution < coplanar_tolerance * size) return {};
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "; the points span " << size << " m at " << distance
       << " m from the origin, where floats are " << resolution
       << " m apart: move them to the origin and give the body a position";
  return text.str();
}

/// The point that is farthest by some measure.
template <class Measure>
Vec3d farthest(std::span<const Vec3> points, const Measure& measure) {
  const auto nearer = [&](const Vec3& a, const Vec3& b) {
    return measure(a.cast<double>()) < measure(b.cast<double>());
  };
  return std::max_element(points.begin(), points.end(), nearer)->template cast<double>();
}

/// How far points reach (m).
struct Extents {
  double length = 0;  ///< from the first point
  double thickness =
      0;  ///< across the plane through three of them that are far apart; 0 if all are on a line
};

Extents extents_of(std::span<const Vec3> points) {
  const Vec3d a = points[0].cast<double>();
  const Vec3d b = farthest(points, [&](const Vec3d& p) { return (p - a).squaredNorm(); });
  const double length = (b - a).norm();
  const Vec3d along = (b - a).normalized();
  const auto from_line = [&](const Vec3d& p) { return (p - a).cross(along).norm(); };
  const Vec3d c = farthest(points, from_line);
  // The normal of points in a line would be rounding.
  if (from_line(c) <= coplanar_tolerance * length) return {length, 0};
  const Vec3d normal = along.cross(c - a).normalized();
  const auto from_plane = [&](const Vec3d& p) { return std::abs(normal.dot(p - a)); };
  return {length, from_plane(farthest(points, from_plane))};
}

/// Whether the points lie in a plane, as far as floats can tell: merging would fold such a hull.
bool are_coplanar(std::span<const Vec3> points) {
  const Extents extents = extents_of(points);
  return extents.thickness <= coplanar_tolerance * extents.length;
}

/// One run of qhull: its state is in here and nowhere else, so that threads do not meet.
class HullRun {
 public:
  explicit HullRun(std::span<const Vec3> points) {
    for (const Vec3& point : points) {
      for (const Real coordinate : point) coordinates_.push_back(coordinate);
    }
    char triangulated[] = "qhull Qt";
    qh_zero(&state_, stderr);
    exit_code_ = qh_new_qhull(&state_, 3, static_cast<int>(points.size()), coordinates_.data(),
                              False, triangulated, nullptr, messages_.get());
  }
  ~HullRun() {
    int blocks_left = 0;
    int bytes_left = 0;
    qh_freeqhull(&state_, !qh_ALL);
    qh_memfreeshort(&state_, &blocks_left, &bytes_left);
  }
  HullRun(const HullRun&) = delete;
  HullRun& operator=(const HullRun&) = delete;

  int exit_code() const { return exit_code_; }

  /// The facets as triangles of the given points, outward.
  std::vector<Triangle> triangles() const {
    std::vector<Triangle> result;
    for (const facetT* facet = state_.facet_list; facet->next != nullptr; facet = facet->next) {
      Triangle triangle;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto* vertex = static_cast<const vertexT*>(facet->vertices->e[i].p);
        triangle.at(i) = static_cast<Index>((vertex->point - coordinates_.data()) / 3);
      }
      if (facet->toporient) std::swap(triangle[1], triangle[2]);
      result.push_back(triangle);
    }
    return result;
  }

 private:
  struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::vector<double> coordinates_;
  // qhull explains its failures at length, in terms of its own options: not for our readers.
  std::unique_ptr<std::FILE, CloseFile> messages_{std::fopen("/dev/null", "w")};
  qhT state_;
  int exit_code_ = 0;
};

/// Keeps the vertices that triangles use, in their order, and renumbers them.
TriangleSoup without_unused_points(std::span<const Vec3> points, std::vector<Triangle> triangles) {
  std::vector<Index> new_number(points.size(), no_index);
  for (const Triangle& triangle : triangles) {
    for (Index v : triangle) new_number[v] = 0;
  }
  TriangleSoup soup;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (new_number[i] == no_index) continue;
    new_number[i] = static_cast<Index>(soup.vertices.size());
    soup.vertices.push_back(points[i]);
  }
  for (Triangle& triangle : triangles) {
    for (Index& v : triangle) v = new_number[v];
  }
  soup.triangles = std::move(triangles);
  return soup;
}

/// The corner opposite to the longest edge of a sliver, no_index of any other triangle.
Index vertex_of_sliver(const TriangleSoup& soup, const Triangle& triangle) {
  const auto corner = [&](std::size_t i) -> Vec3d {
    return soup.vertices[triangle[i % 3]].cast<double>();
  };
  std::size_t tip = 0;
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double length = (corner(i + 2) - corner(i + 1)).norm();
    if (length > longest) {
      longest = length;
      tip = i;
    }
  }
  const double twice_area = (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
  return twice_area < sliver_height * longest * longest ? triangle[tip] : no_index;
}

/// Removes the vertices that make slivers from the soup, which is a point cloud from then on. Each of them
/// is beside an edge of the hull, so the hull of the rest differs by no more than a sliver's height.
/// @return whether there were any
bool drop_slivers(TriangleSoup& soup) {
  std::vector<bool> dropped(soup.vertices.size(), false);
  for (const Triangle& triangle : soup.triangles) {
    const Index v = vertex_of_sliver(soup, triangle);
    const bool is_alone = std::none_of(triangle.begin(), triangle.end(),
                                       [&](Index corner) { return dropped[corner]; });
    // The next hull tells about triangles that have lost a corner already.
    if (v != no_index && is_alone) dropped[v] = true;
  }
  std::vector<Vec3> kept;
  for (std::size_t v = 0; v < soup.vertices.size(); ++v) {
    if (!dropped[v]) kept.push_back(soup.vertices[v]);
  }
  const bool any = kept.size() < soup.vertices.size();
  soup.vertices = std::move(kept);
  return any;
}

/// The volume of a hull (m³).
double volume_of(const TriangleSoup& hull) {
  const Vec3d origin = hull.vertices[0].cast<double>();
  const auto corner = [&](Index v) -> Vec3d { return hull.vertices[v].cast<double>() - origin; };
  double volume = 0;
  for (const auto& [a, b, c] : hull.triangles) {
    volume += corner(a).dot(corner(b).cross(corner(c))) / 6;
  }
  return volume;
}

/// A hull that loses more than this part of its volume lacks corners: the slivers were its sides. A rod of 13 to
/// 35 sides loses at least 2 %, and a plate with a point beside an edge 1/30000.
constexpr double allowed_loss = 1e-2;

SoupResult too_thin(std::span<const Vec3> points) {
  const Extents extents = extents_of(points);
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "the points span " << extents.length << " m, but only " << extents.thickness
       << " m across: the sides of their hull are too narrow for floats. Each side needs at least "
          "1/10000 of its length as its width";
  return {{}, text.str() + advice_if_far(points)};
}

}  // namespace

SoupResult convex_hull(std::span<const Vec3> points) {
  if (const std::string fault = first_fault(points); !fault.empty()) return {{}, fault};
  if (are_too_far(points)) {
    return {{}, "the points are too far from the origin" + advice_if_far(points)};
  }
  if (are_coplanar(points)) {
    return {
        {},
        "the points lie in one plane: a hull needs a point outside of it" + advice_if_far(points)};
  }
  TriangleSoup soup{{points.begin(), points.end()}, {}};
  double volume = 0;  // of the first hull, which has all corners
  for (;;) {
    // Without its slivers a thin hull may be flat. Fewer than four points would make qhull exit.
    if (soup.vertices.size() < 4 || are_coplanar(soup.vertices)) {
      return too_thin(points);
    }
    const HullRun run(soup.vertices);
    if (run.exit_code() != 0) {
      return {{},
              "qhull gives up on these points (error " + std::to_string(run.exit_code()) +
                  "): spread them, or remove those that nearly coincide" + advice_if_far(points)};
    }
    soup = without_unused_points(soup.vertices, run.triangles());
    volume = std::max(volume, volume_of(soup));
    if (!drop_slivers(soup)) break;
  }
  if (volume_of(soup) < (1 - allowed_loss) * volume) return too_thin(points);
  return {std::move(soup), {}};
}

}  // namespace cs550
