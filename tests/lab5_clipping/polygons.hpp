#pragma once
/// @file polygons.hpp
/// Polygons for the tests of clip_polygon().

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "cs550/clipping.hpp"
#include "helpers/random.hpp"
#include "helpers/require.hpp"
#include "helpers/story.hpp"

namespace cs550::test {

/// A polygon whose edge from corner i to corner i + 1 is called incident edge i.
inline ClipPolygon polygon_of(const std::vector<Vec3>& corners) {
  ClipPolygon polygon;
  const Index count = static_cast<Index>(corners.size());
  for (Index i = 0; i < count; ++i) {
    polygon.push_back({corners[i],
                       {ClipEdge::Source::Incident, (i + count - 1) % count},
                       {ClipEdge::Source::Incident, i}});
  }
  return polygon;
}

/// The square from (0, 0) to (1, 1) in the plane z = 0.
/// @{
inline std::vector<Vec3> unit_square_corners() {
  return {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
}
inline ClipPolygon unit_square() { return polygon_of(unit_square_corners()); }
/// @}

inline std::string show(const ClipPolygon& polygon) {
  std::ostringstream text;
  text << polygon.size() << (polygon.size() == 1 ? " corner" : " corners");
  for (int i = 0; i < polygon.size(); ++i) {
    text << (i == 0 ? ": " : ", ") << Story::show(polygon[i].point);
  }
  return text.str();
}

/// The same polygon, starting at another corner.
inline ClipPolygon rotated(const ClipPolygon& polygon, int first) {
  ClipPolygon result;
  for (int i = 0; i < polygon.size(); ++i) {
    result.push_back(polygon[(first + i) % polygon.size()]);
  }
  return result;
}

inline bool same_corners(const ClipPolygon& p, const ClipPolygon& q, Real tolerance) {
  return std::equal(p.begin(), p.end(), q.begin(), q.end(),
                    [=](const ClipVertex& a, const ClipVertex& b) {
                      return (a.point - b.point).norm() <= tolerance;
                    });
}

/// Checks the corners in this cyclic order, starting at any of them.
inline bool expect_corners(Story& story, const ClipPolygon& got, const std::vector<Vec3>& expected,
                           Real tolerance = 0, SourceLine at = {}) {
  const ClipPolygon wanted = polygon_of(expected);
  for (int first = 0; first < std::max(1, got.size()); ++first) {
    if (same_corners(rotated(got, first), wanted, tolerance)) return true;
  }
  story.expect_equal("corners, counter-clockwise", show(got), show(wanted), at);
  return false;
}

}  // namespace cs550::test
