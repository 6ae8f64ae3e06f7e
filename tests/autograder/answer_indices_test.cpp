// Answers of a submission that name elements which do not exist.
#include "autograder/grader/remote/answer_indices.hpp"

#include <gtest/gtest.h>

#include "helpers/fixtures.hpp"

namespace cs550::grader {
namespace {

constexpr Index wild = 1 << 28;
const Vec3 up(0, 0, 1);

class AnswerIndices : public testing::Test {
 protected:
  template <class... Values>
  static bool is_refused(const Values&... values) {
    try {
      check_indices(values...);
      return false;
    } catch (const cereal::Exception&) {
      return true;
    }
  }

  const ShapePtr shape = test::fixture_shape("box_1x2x3");  // 8 vertices, 24 half-edges, 6 faces
  const PosedShape body{shape.get(), {}};
  const Index start = 0;
  const Real number = 0;
};

TEST_F(AnswerIndices, OfSupportsNameAVertexOrNone) {
  std::vector<Index> climbed;
  std::vector<Index>* path = &climbed;
  const auto climb = [&](Index vertex) {
    return is_refused(Support{vertex, 1}, shape->mesh, up, start, path);
  };
  EXPECT_FALSE(climb(7));
  EXPECT_FALSE(climb(no_index));
  EXPECT_TRUE(climb(8));
  EXPECT_TRUE(climb(-2));
  climbed = {0, wild};
  EXPECT_TRUE(climb(7));
  path = nullptr;
  EXPECT_FALSE(climb(7));
  EXPECT_TRUE(is_refused(Support{wild, 1}, std::span(shape->mesh.vertices), up));
  EXPECT_TRUE(is_refused(SupportPoint{wild, up}, body, up, start));
}

TEST_F(AnswerIndices, OfSeparatingAxesNameFeaturesOfTheirBody) {
  const SeparatingAxis hint;
  const auto axis = [&](const SeparatingAxis& answer) {
    return is_refused(answer, body, body, hint, number);
  };
  EXPECT_FALSE(axis({AxisFeature::FaceA, up, 0, {5, 7, 0}, {}, {}}));
  EXPECT_TRUE(axis({AxisFeature::FaceA, up, 0, {6, 7, 0}, {}, {}}));
  EXPECT_TRUE(axis({AxisFeature::FaceB, up, 0, {}, {5, 8, 0}, {}}));
  EXPECT_TRUE(axis({AxisFeature::Edges, up, 0, {}, {}, {0, 24, up, 0}}));
  EXPECT_TRUE(axis({static_cast<AxisFeature>(4), up, 0, {}, {}, {}}));
  EXPECT_TRUE(is_refused(FaceQuery{wild, 0, 0}, body, body));
  EXPECT_TRUE(is_refused(EdgeQuery{0, wild, up, 0}, body, body));
}

TEST_F(AnswerIndices, OfMeshesNameTheirOwnElements) {
  const auto build = [](const HalfEdgeMesh& mesh) {
    return is_refused(MeshBuild{mesh, {}}, std::span<const Vec3>(), std::span<const Triangle>());
  };
  EXPECT_FALSE(build(shape->mesh));
  HalfEdgeMesh mesh = shape->mesh;
  mesh.edges[3].next = no_index;  // before its step is written
  EXPECT_FALSE(build(mesh));
  mesh.edges[3].next = 24;
  EXPECT_TRUE(build(mesh));
  EXPECT_TRUE(is_refused(mesh, shape->mesh, number));
  mesh = shape->mesh;
  mesh.vertex_edge[0] = wild;
  EXPECT_TRUE(build(mesh));
}

TEST_F(AnswerIndices, OfContactsNameKnownFeatures) {
  EXPECT_FALSE(is_refused(Index{5}, body, 0, up));
  EXPECT_TRUE(is_refused(Index{6}, body, 0, up));
  Manifold manifold;
  manifold.points.push_back({});
  EXPECT_FALSE(is_refused(manifold, body, body));
  manifold.points[0].feature.bits = 0xf0000000;
  EXPECT_TRUE(is_refused(manifold, body, body));
  EXPECT_TRUE(is_refused(manifold.points, std::span<const ContactPoint>(), up));
}

TEST_F(AnswerIndices, OfConstraintsStayAsTheyWere) {
  std::vector<ContactConstraint> was(2);
  was[1].body_a = 1;
  was[1].body_b = 2;
  std::vector<ContactConstraint> is = was;
  is[1].body_a = wild;
  is[1].body_b = -wild;
  is[1].normal_impulse = 3;
  keep_bodies(was, is);
  EXPECT_EQ(is[1].body_a, 1);
  EXPECT_EQ(is[1].body_b, 2);
  EXPECT_EQ(is[1].normal_impulse, 3);
  is.pop_back();
  EXPECT_THROW(keep_bodies(was, is), cereal::Exception);
}

}  // namespace
}  // namespace cs550::grader
