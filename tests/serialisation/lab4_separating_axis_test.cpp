#include <gtest/gtest.h>

#include <cmath>

#include "cs550/separating_axis.hpp"
#include "serialisation/wire.hpp"

namespace cs550::test {
namespace {

TEST(Serialisation, Lab4IsCalledAcrossAWire) {
  const PosedShape& a = two_bodies().a;
  const PosedShape& b = two_bodies().b;
  const SeparatingAxis axis = find_separating_axis(a, b, {}, HUGE_VALF);
  EXPECT_SAME_ACROSS_WIRE(is_minkowski_face, Vec3::UnitX(), Vec3::UnitY(),
                          Vec3(1, 1, 1).normalized(), Vec3(1, 1, -1).normalized());
  EXPECT_SAME_ACROSS_WIRE(query_face_directions, a, b);
  EXPECT_SAME_ACROSS_WIRE(query_edge_directions, a, b);
  EXPECT_SAME_ACROSS_WIRE(find_separating_axis, a, b, axis, 0.1F);
  EXPECT_SAME_ACROSS_WIRE(overlap, a, b);
}

TEST(Serialisation, NoMemberOfLab4IsForgotten) {
  EXPECT_EVERY_WORD_SENT(FaceQuery);
  EXPECT_EVERY_WORD_SENT(EdgeQuery);
  EXPECT_EVERY_WORD_SENT(SeparatingAxis);
}

}  // namespace
}  // namespace cs550::test
