#include <gtest/gtest.h>

#include "cs550/primitives.hpp"
#include "cs550/separating_axis.hpp"

using namespace cs550;

ShapePtr box(const Vec3& half_extents) {
  const TriangleSoup soup = box_soup(half_extents);
  return make_shape(soup.vertices, soup.triangles).shape;
}

/// Two cubes of 2 m, their centres `distance` apart along x.
class Cubes : public testing::Test {
 protected:
  static PosedShape at(const ShapePtr& shape, Real distance, const Quat& orientation) {
    Pose pose;
    pose.position = Vec3(distance, 0, 0);
    pose.orientation = orientation;
    return {shape.get(), pose};
  }
  ShapePtr cube = box(Vec3(1, 1, 1));
  Quat none = Quat::Identity();
};

TEST_F(Cubes, AreAsFarApartAsTheirFaces) {
  const PosedShape a = at(cube, 0, none);
  const PosedShape b = at(cube, Real(2.5), none);
  const FaceQuery query = query_face_directions(a, b);
  EXPECT_NEAR(query.separation, 0.5, 1e-5);
  EXPECT_NEAR(a.plane(query.face).normal.x(), 1, 1e-5);
  EXPECT_FALSE(overlap(a, b));
  EXPECT_TRUE(overlap(a, at(cube, Real(1.5), none)));
}

TEST_F(Cubes, MeetEdgeToEdge) {
  const Real quarter = pi / 4;
  const PosedShape a = at(cube, 0, rotation_exp(Vec3(0, 0, quarter)));
  const PosedShape b = at(cube, Real(2.9), rotation_exp(Vec3(0, quarter, 0)));
  const EdgeQuery query = query_edge_directions(a, b);
  ASSERT_TRUE(query);
  EXPECT_NEAR(query.axis.x(), 1, 1e-4);
  EXPECT_NEAR(query.separation, 2.9 - 2 * std::sqrt(2.0), 1e-4);
  const SeparatingAxis axis = find_separating_axis(a, b, {}, 1);
  EXPECT_EQ(axis.feature, AxisFeature::Edges);
}
