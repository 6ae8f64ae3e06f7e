#pragma once
// Pairs that touch at crossed edges. The ridge of the lower body is an edge along x, and the keel
// of the upper body is an edge across it. Their separation along z is the distance of the centres
// minus the heights of both.

#include <string>
#include <vector>

#include "lab4_separating_axis/axis_oracle.hpp"

namespace cs550::test {

struct CrossedShape {
  std::string fixture;
  Vec3 along;   ///< the direction of its ridge, body frame
  Vec3 upward;  ///< from its centroid to the middle of that edge, body frame (m)
};

/// A cube on one of its edges, and n-gon prisms: 32 edges of each cross 32 of the other.
inline const std::vector<CrossedShape>& crossed_shapes() {
  static const std::vector<CrossedShape> shapes{
      {"cube", Vec3::UnitX(), Vec3(0, Real(0.5), Real(0.5))},
      {"prism3", Vec3::UnitZ(), Vec3(1, 0, 0)},
      {"prism6", Vec3::UnitZ(), Vec3(1, 0, 0)},
      {"prism32", Vec3::UnitZ(), Vec3(1, 0, 0)},
  };
  return shapes;
}

struct CrossedPair {
  TestPair pair;
  ShapePtr shape;  ///< owns the shape of both
  double separation = 0;
};

/// The orientation that maps the ridge to a horizontal direction and its middle to ±z.
inline Quat stand(const CrossedShape& shape, const Vec3& along, const Vec3& up) {
  const auto frame = [](const Vec3& x, const Vec3& z) {
    Mat3 columns;
    columns << x, z.cross(x), z;
    return columns;
  };
  return Quat(Mat3(frame(along, up) * frame(shape.along, shape.upward.normalized()).transpose()))
      .normalized();
}

/// @param overlap_share their overlap as a share of the height of both
/// @param yaw between ridge and keel (rad)
inline CrossedPair cross(const CrossedShape& kind, Real size, Real overlap_share,
                         Real yaw = pi / 2) {
  CrossedPair crossed;
  crossed.shape = scaled_shape(kind.fixture, size);
  const Real heights = 2 * size * kind.upward.norm();
  const Vec3 place(0, 0, heights * (1 - overlap_share));
  const Vec3 keel(std::cos(yaw), std::sin(yaw), 0);
  crossed.pair = {{crossed.shape.get(), {Vec3::Zero(), stand(kind, Vec3::UnitX(), Vec3::UnitZ())}},
                  {crossed.shape.get(), {place, stand(kind, keel, -Vec3::UnitZ())}},
                  kind.fixture + " crossed edge over edge"};
  crossed.separation = double{place.z()} - double{heights};
  return crossed;
}

/// Two cubes of 1 m that only the axis of two edges separates, by 20 µm. A face of A overlaps B by 30 µm, within
/// the tolerance of a tie: B's keel crosses A's edge at x = z = 0.5 m, tilted by 1e-4 rad into A.
inline CrossedPair barely_apart() {
  const CrossedShape& cube = crossed_shapes()[0];
  CrossedPair crossed;
  crossed.shape = scaled_shape(cube.fixture, 1);
  crossed.separation = 2e-5;
  const Vec3 axis(Real(1e-4), 0, 1);
  const Vec3 keel(1, 0, Real(-1e-4));
  const Vec3 edge(Real(0.5), 0, Real(0.5));
  const Vec3 place = edge + (cube.upward.norm() + Real(crossed.separation)) * axis;
  crossed.pair = {{crossed.shape.get(), {Vec3::Zero(), Quat::Identity()}},
                  {crossed.shape.get(), {place, stand(cube, keel, -axis)}},
                  "cubes 20 µm apart along an axis of edges, a face 30 µm deep"};
  return crossed;
}

}  // namespace cs550::test
