#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "helpers/fixtures.hpp"
#include "serialisation/named_content.hpp"

namespace cs550::test {
namespace {

using namespace serialisation;

TEST(Serialisation, AShapeIsNamedByItsContent) {
  const ShapePtr cube = fixture_shape("cube");
  const ShapePtr twin = make_shape(fixture_mesh("cube")).shape;
  EXPECT_EQ(content_hash(*cube), content_hash(*twin));
  EXPECT_NE(content_hash(*cube), content_hash(*fixture_shape("needle")));
  EXPECT_LT(to_bytes(PosedShape{cube.get(), {}}).size(), 50U);
}

TEST(Serialisation, AShapeThatWasNeverSentIsMissed) {
  const std::string bytes = to_bytes(PosedShape{fixture_shape("cube").get(), {}});
  const ContentRegistry none;
  EXPECT_THROW(from_bytes<PosedShape>(bytes, &none), std::out_of_range);
}

TEST(Serialisation, AMeshIsNamedByItsContent) {
  const HalfEdgeMesh cube = fixture_mesh("cube");
  const HalfEdgeMesh twin = cube;
  HalfEdgeMesh other = cube;
  other.vertices.front().x() += 1;
  EXPECT_EQ(content_hash(cube), content_hash(twin));
  EXPECT_NE(content_hash(cube), content_hash(other));
  EXPECT_LT(to_bytes(NamedMesh(cube)).size(), 50U);
}

TEST(Serialisation, AMeshThatWasNeverSentIsMissed) {
  const HalfEdgeMesh cube = fixture_mesh("cube");
  const ContentRegistry none;
  EXPECT_THROW(from_bytes<NamedMesh>(to_bytes(NamedMesh(cube)), &none), std::out_of_range);
}

}  // namespace
}  // namespace cs550::test
