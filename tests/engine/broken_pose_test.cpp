// A pose that is not a number: a query ends, and what it names exists.

#include <gtest/gtest.h>

#include <limits>

#include "cs550/separating_axis.hpp"
#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

bool names_existing_features(const FaceQuery& query, const HalfEdgeMesh& faces_of,
                             const HalfEdgeMesh& vertices_of) {
  if (!query) return true;
  return query.face < faces_of.face_count() && query.vertex >= 0 &&
         query.vertex < vertices_of.vertex_count();
}

TEST(BrokenPose, AQueryNamesFeaturesThatExist) {
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
  const Pose poses[] = {{Vec3(nan, 0, 0), Quat::Identity()}, {Vec3::Zero(), Quat(nan, 0, 0, 1)}};
  Random random(82);
  for (const int vertices : {4, 8, 16, 32, 48, 128}) {
    const ShapePtr shape = random_hull(random, vertices, Vec3::Ones());
    const PosedShape whole{shape.get(), Pose{}};
    for (const Pose& pose : poses) {
      const PosedShape broken{shape.get(), pose};
      for (const auto& [a, b] : {std::pair(whole, broken), std::pair(broken, whole)}) {
        SCOPED_TRACE(testing::Message() << vertices << " vertices");
        const SeparatingAxis axis = find_separating_axis(a, b, {}, Real(0.02));
        EXPECT_TRUE(names_existing_features(axis.face_a, a.mesh(), b.mesh()));
        EXPECT_TRUE(names_existing_features(axis.face_b, b.mesh(), a.mesh()));
      }
    }
  }
}

}  // namespace
}  // namespace cs550
