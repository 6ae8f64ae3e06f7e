// Warm starting: which impulses of the last step are carried to the points of this step.

#include <gtest/gtest.h>

#include "cs550/contact.hpp"
#include "helpers/random.hpp"

namespace cs550::test {
namespace {

Manifold frame(const Vec3& normal, const Vec3& tangent) {
  Manifold manifold;
  manifold.normal = normal;
  manifold.tangent = tangent;
  return manifold;
}

ContactPoint point(Index feature, Real normal_impulse, const Vec2& tangent_impulse) {
  ContactPoint result;
  result.feature = {FeatureId::Kind::Edges, feature, 0};
  result.normal_impulse = normal_impulse;
  result.tangent_impulse = tangent_impulse;
  return result;
}

ContactPoint at(const Vec3& anchor_a, ContactPoint point) {
  point.anchor_a = anchor_a;
  return point;
}

Vec3 tangent_impulse_in_world(const Manifold& manifold, const ContactPoint& point) {
  return point.tangent_impulse.x() * manifold.tangent +
         point.tangent_impulse.y() * manifold.normal.cross(manifold.tangent);
}

TEST(CarryImpulses, MatchesByFeatureWhateverTheOrder) {
  Manifold before = frame(Vec3::UnitZ(), Vec3::UnitX());
  before.points.push_back(point(1, 10, Vec2(1, 2)));
  before.points.push_back(point(2, 20, Vec2(3, 4)));
  Manifold now = frame(Vec3::UnitZ(), Vec3::UnitX());
  now.points.push_back(point(2, 0, Vec2::Zero()));
  now.points.push_back(point(1, 0, Vec2::Zero()));
  carry_impulses(before, now);
  EXPECT_EQ(now.points[0].normal_impulse, 20);
  EXPECT_EQ(now.points[0].tangent_impulse, Vec2(3, 4));
  EXPECT_EQ(now.points[1].normal_impulse, 10);
  EXPECT_EQ(now.points[1].tangent_impulse, Vec2(1, 2));
}

TEST(CarryImpulses, KeepsTheFrictionInTheWorldWhenTheTangentTurns) {
  Random random(91);
  for (int i = 0; i < 100; ++i) {
    const Vec3 normal = random.unit_vector();
    const Vec3 u = any_perpendicular(normal);
    const Real angle = random.real(0, 2 * pi);
    Manifold before = frame(normal, u);
    before.points.push_back(point(7, 1, Vec2(Real(0.3), Real(-0.2))));
    Manifold now = frame(normal, std::cos(angle) * u + std::sin(angle) * normal.cross(u));
    now.points.push_back(point(7, 0, Vec2::Zero()));
    carry_impulses(before, now);
    const Vec3 change = tangent_impulse_in_world(now, now.points[0]) -
                        tangent_impulse_in_world(before, before.points[0]);
    EXPECT_LE(change.norm(), 1e-6) << "seed " << random.seed() << ", turned by " << angle;
  }
}

TEST(CarryImpulses, PushesAlongTheNewNormalOrNotAtAll) {
  const auto carried = [](const Vec3& new_normal) {
    Manifold before = frame(Vec3::UnitZ(), Vec3::UnitX());
    before.points.push_back(point(7, 10, Vec2::Zero()));
    Manifold now = frame(new_normal, any_perpendicular(new_normal));
    now.points.push_back(point(7, 0, Vec2::Zero()));
    carry_impulses(before, now);
    return now.points[0].normal_impulse;
  };
  // 10 N·s times the cosine between the normals: 0.8 and −1.
  EXPECT_NEAR(carried(Vec3(Real(0.6), 0, Real(0.8))), 8, 1e-5);
  EXPECT_EQ(carried(-Vec3::UnitZ()), 0);
}

// Of the old points the second is 1 mm from the new feature, but belongs to the feature that stayed.
TEST(CarryImpulses, ANewFeatureTakesWhatNoFeatureClaims) {
  Manifold before = frame(Vec3::UnitZ(), Vec3::UnitX());
  before.points.push_back(at({0, 0, 0}, point(1, 10, Vec2(3, 4))));
  before.points.push_back(at({1, 0, 0}, point(2, 20, Vec2(6, 7))));
  Manifold now = frame(Vec3::UnitZ(), Vec3::UnitX());
  now.points.push_back(at({Real(1.001), 0, 0}, point(8, 0, Vec2::Zero())));
  now.points.push_back(at({1, 0, 0}, point(2, 0, Vec2::Zero())));
  now.points.push_back(at({3, 0, 0}, point(9, 5, Vec2(1, 2))));
  carry_impulses(before, now);
  EXPECT_EQ(now.points[0].normal_impulse, 10);
  EXPECT_EQ(now.points[0].tangent_impulse, Vec2(3, 4));
  EXPECT_EQ(now.points[1].normal_impulse, 20);
  EXPECT_EQ(now.points[1].tangent_impulse, Vec2(6, 7));
  EXPECT_EQ(now.points[2].normal_impulse, 5) << "no old point is left";
  EXPECT_EQ(now.points[2].tangent_impulse, Vec2(1, 2));
}

// Neither the order of the points nor their anchors on B decide.
TEST(CarryImpulses, OfNewFeaturesEachTakesTheNearestOldPoint) {
  for (const bool swapped : {false, true}) {
    const Real near_first = swapped ? 1 : 0;
    Manifold before = frame(Vec3::UnitZ(), Vec3::UnitX());
    before.points.push_back(at({0, 0, 0}, point(1, 10, Vec2(1, 2))));
    before.points.push_back(at({1, 0, 0}, point(2, 20, Vec2(3, 4))));
    Manifold now = frame(Vec3::UnitZ(), Vec3::UnitX());
    now.points.push_back(at({near_first, Real(0.1), 0}, point(8, 0, Vec2::Zero())));
    now.points.push_back(at({1 - near_first, Real(0.1), 0}, point(9, 0, Vec2::Zero())));
    carry_impulses(before, now);
    EXPECT_EQ(now.points[0].normal_impulse, swapped ? 20 : 10);
    EXPECT_EQ(now.points[1].normal_impulse, swapped ? 10 : 20);
  }
}

TEST(CarryImpulses, LeavesAManifoldWithoutPastAlone) {
  Manifold now = frame(Vec3::UnitZ(), Vec3::UnitX());
  now.points.push_back(point(7, 5, Vec2(1, 2)));
  carry_impulses(Manifold(), now);
  EXPECT_EQ(now.points[0].normal_impulse, 5);
  EXPECT_EQ(now.points[0].tangent_impulse, Vec2(1, 2));
}

}  // namespace
}  // namespace cs550::test
