#include <gtest/gtest.h>

#include "cs550/hill_climbing.hpp"
#include "helpers/fixtures.hpp"
#include "serialisation/wire.hpp"

namespace cs550::test {
namespace {

TEST(Serialisation, Lab3IsCalledAcrossAWire) {
  const HalfEdgeMesh sphere = fixture_mesh("icosphere2");
  EXPECT_SAME_ACROSS_WIRE(support_brute_force, sphere.vertices, {1, 2, 3});
  EXPECT_SAME_ACROSS_WIRE(hill_climb, NamedMesh(sphere), {1, 2, 3}, 5, std::vector<Index>());
  EXPECT_SAME_ACROSS_WIRE(hill_climb, NamedMesh(sphere), {1, 2, 3}, 5, std::nullopt);
  EXPECT_SAME_ACROSS_WIRE(support, two_bodies().b, {1, 2, 3}, 5);
}

TEST(Serialisation, NoMemberOfLab3IsForgotten) {
  EXPECT_EVERY_WORD_SENT(Support);
  EXPECT_EVERY_WORD_SENT(SupportPoint);
}

}  // namespace
}  // namespace cs550::test
