// Drawings on top of a world.
#include "pages/world/overlays.hpp"

#include <gtest/gtest.h>

namespace cs550::test {
namespace {

using namespace pages;

constexpr Real length = 1;  // of a contact normal (m)

WorldFrame bodies_with_speeds(std::initializer_list<Real> speeds) {
  WorldFrame frame;
  for (const Real speed : speeds) {
    RigidBody body;
    body.kind = BodyKind::Dynamic;
    body.linear_velocity = {speed, 0, 0};
    body.pose.position = {0, static_cast<Real>(frame.bodies.size()), 0};
    frame.bodies.push_back(body);
    frame.is_alive.push_back(1);
    frame.mesh_of_body.push_back(no_index);
    frame.bounds.emplace_back();
  }
  return frame;
}

drawing::Drawing velocities_of(std::initializer_list<Real> speeds) {
  Overlays overlays;
  overlays.velocities = true;
  return draw_overlays(overlays, bodies_with_speeds(speeds), {}, length);
}

Real shown(const drawing::Line& line) { return (line.to - line.from).norm(); }

TEST(Overlays, ArrowsAreInProportion) {
  const drawing::Drawing drawing = velocities_of({1, 2, 3});
  ASSERT_EQ(drawing.lines.size(), 3U);
  EXPECT_NEAR(shown(drawing.lines[1]), 2 * shown(drawing.lines[0]), 1e-5);
  EXPECT_NEAR(shown(drawing.lines[2]), 3 * shown(drawing.lines[0]), 1e-5);
  EXPECT_TRUE(drawing.notes.empty());
}

TEST(Overlays, OneFastBodyDoesNotHideTheSpeedOfTheOthers) {
  const drawing::Drawing drawing = velocities_of({4, 4, 4, 4, 4, 4, 4, 40});
  ASSERT_EQ(drawing.lines.size(), 8U);
  EXPECT_GT(shown(drawing.lines[0]), length) << "a usual one is well seen";
  EXPECT_LT(shown(drawing.lines[7]), 3 * shown(drawing.lines[0])) << "the longest is cut";
  EXPECT_FALSE(drawing.lines[0].stroke.dashed);
  EXPECT_TRUE(drawing.lines[7].stroke.dashed);
  ASSERT_EQ(drawing.notes.size(), 1U);
  EXPECT_NE(drawing.notes[0].find("drawn shorter than they are"), std::string::npos);
}

TEST(Overlays, NoiseBesideMotionIsNotDrawn) {
  EXPECT_EQ(velocities_of({1e-5F, 1e-5F, 1e-5F, 2}).lines.size(), 1U);
  EXPECT_TRUE(velocities_of({0, 0}).lines.empty());
  EXPECT_TRUE(velocities_of({NAN}).lines.empty());
}

TEST(Overlays, WhatIsDrawnIsNamed) {
  Overlays overlays;
  overlays.contacts = true;
  overlays.feature_ids = true;
  overlays.centers = true;
  WorldFrame frame = bodies_with_speeds({0, 0});
  Contact& contact = frame.contacts.emplace_back();
  contact.body_a = 0;
  contact.body_b = 1;
  contact.manifold.normal = Vec3::UnitZ();
  ContactPoint point;
  point.feature = FeatureId(FeatureId::Kind::VertexOnFaceA, 5, 2);
  contact.manifold.points.push_back(point);
  const drawing::Drawing drawing = draw_overlays(overlays, frame, {}, length);
  ASSERT_EQ(drawing.labels.size(), 1U);
  EXPECT_EQ(drawing.labels[0].text, "A f5 B v2");
  EXPECT_EQ(drawing.points.size(), 3U) << "a contact and two centres";
  EXPECT_EQ(drawing.legend.size(), 3U);
  EXPECT_EQ(drawing.notes.size(), 1U) << "which explains the short names";
}

}  // namespace
}  // namespace cs550::test
