// The hull builder: any points have a hull that holds them all, or a reason why not.

#include "cs550/primitives.hpp"
#include "points.hpp"
#include "promise.hpp"

using namespace cs550;

namespace {

/// Merging and dropped slivers move a face by this part of the hull's size at most.
constexpr Real tolerance = Real(1e-3);

void check_hull(const std::vector<Vec3>& points, const ConvexShape& shape) {
  const Real allowed = tolerance * shape.bounds.extent().norm();
  for (const Face& face : shape.mesh.faces) {
    for (const Vec3& point : points) {
      const Real distance = face.plane.distance(point + shape.source_origin);
      fuzz::promise(!(distance > allowed), "no point is outside of its hull");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes(data, size);
  const std::vector<Vec3> points = fuzz::take_points(bytes, 40);
  const SoupResult hull = convex_hull(points);
  if (!hull.error.empty()) {
    fuzz::promise(hull.soup.vertices.empty(), "refused points have no hull");
    return 0;
  }
  const ShapeResult made = make_shape(hull.soup.vertices, hull.soup.triangles);
  if (made) check_hull(points, *made.shape);
  fuzz::promise(made || !made.error.empty(), "a refused hull has a reason");
  return 0;
}
