#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "helpers/fixtures.hpp"
#include "serialisation/shape_archive.hpp"

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
  const ShapeRegistry none;
  EXPECT_THROW(from_bytes<PosedShape>(bytes, &none), std::out_of_range);
}

}  // namespace
}  // namespace cs550::test
