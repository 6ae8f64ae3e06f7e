// L5.1: random polygons in random planes, against half-planes in double precision.
#include <cs550/graded_test.hpp>

#include <algorithm>

#include "lab5_clipping/contacts.hpp"
#include "lab5_clipping/polygons.hpp"

namespace cs550::test {
namespace {

GRADED_TEST(Lab5, RandomPolygonsAreClippedToHalfPlanes, 3, "L5.1") {
  Random random(151);
  Story story("A clipped polygon has all corners that are inside, and one where an edge crosses");
  story.seed(random.seed())
      .likely("behind → front emits two corners, the intersection and then the second end")
      .likely("the intersection is at the share d_a / (d_a − d_b) of the way from a to b");
  for (int i = 0; i < 2000; ++i) {
    const Real size = i % 3 == 0 ? Real(1e-3) : i % 3 == 1 ? Real(1) : Real(1e3);
    const Vec3 normal = random.unit_vector();
    const Vec3 u = any_perpendicular(normal);
    std::vector<Real> angles(random.integer(3, 12));
    for (Real& angle : angles) angle = random.real(0, 2 * pi);
    std::sort(angles.begin(), angles.end());
    std::vector<Vec3> corners;
    corners.reserve(angles.size());
    for (const Real angle : angles) {
      corners.push_back(size * (std::cos(angle) * u + std::sin(angle) * normal.cross(u)));
    }
    const Plane plane{random.unit_vector(), size * random.real(Real(-0.8), Real(0.8))};
    const auto distance = [&](const Vec3& p) {
      return plane.normal.cast<double>().dot(p.cast<double>()) - static_cast<double>(plane.offset);
    };
    std::vector<Vec3> expected;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec3& a = corners[k];
      const Vec3& b = corners[(k + 1) % corners.size()];
      const double d_a = distance(a);
      const double d_b = distance(b);
      if (d_a <= 0) expected.push_back(a);
      if (d_a * d_b < 0) {
        const Point crossing = a.cast<double>() + d_a / (d_a - d_b) * (b - a).cast<double>();
        expected.push_back(crossing.cast<Real>());
      }
    }
    Story here = story;
    here.given("corners", corners.size()).given("size", size, "m");
    // Where an edge runs along the plane, rounding of the distances moves the crossing along it.
    require(expect_corners(here, clip_polygon(polygon_of(corners), plane), expected,
                           Real(2e-4) * size));
  }
}

}  // namespace
}  // namespace cs550::test
