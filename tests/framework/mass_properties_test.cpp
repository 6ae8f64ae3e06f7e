#include "cs550/mass_properties.hpp"

#include <gtest/gtest.h>

#include "cs550/primitives.hpp"

namespace cs550::test {
namespace {

/// A few roundings of the results from double to float.
constexpr Real rounding = Real(3e-7);

HalfEdgeMesh mesh_of(const TriangleSoup& soup) {
  const MeshBuild build = build_half_edge_mesh(soup.vertices, soup.triangles);
  EXPECT_FALSE(build.issue) << describe(build.issue);
  return build.mesh;
}

/// The same solid in another frame or size. Integration does not need its planes.
template <class Map>
HalfEdgeMesh mapped(HalfEdgeMesh mesh, const Map& map) {
  for (Vec3& vertex : mesh.vertices) vertex = map(vertex);
  return mesh;
}

Mat3 diagonal(Real x, Real y, Real z) { return Vec3(x, y, z).asDiagonal(); }

void expect_near(const Mat3& got, const Mat3& expected, Real tolerance) {
  EXPECT_LE((got - expected).cwiseAbs().maxCoeff(), tolerance) << got << "\nexpected\n" << expected;
}

TEST(MassProperties, CornerTetrahedronInClosedForm) {
  const MassProperties got = mass_properties(mesh_of(tetrahedron_soup(1)));
  EXPECT_NEAR(got.volume, 1.0 / 6, rounding);
  EXPECT_LE((got.centroid - Vec3::Constant(0.25F)).norm(), rounding);
  // ∫ y² + z² − V·(2/16) = 1/30 − 1/48, and −(∫ xy − V/16) = −(1/120 − 1/96)
  Mat3 expected = Mat3::Constant(Real(1.0 / 480));
  expected.diagonal().setConstant(Real(1.0 / 80));
  expect_near(got.unit_inertia, expected, rounding / 100);
}

TEST(MassProperties, BoxInClosedForm) {
  const MassProperties got = mass_properties(mesh_of(box_soup({0.5F, 1, 1.5F})));
  EXPECT_NEAR(got.volume, 6, 6 * rounding);
  EXPECT_LE(got.centroid.norm(), rounding);
  // m/12·(b² + c²) with m = 6
  expect_near(got.unit_inertia, diagonal(6.5F, 5, 2.5F), 7 * rounding);
}

TEST(MassProperties, RegularPrismInClosedForm) {
  const double sides = 6, radius = 2, height = 3, turn = 2 * double(pi) / sides;
  const double volume = sides / 2 * radius * radius * std::sin(turn) * height;
  // Second moment of a regular polygon about its centre: area·R²·(2 + cos(2π/n))/6, half for an
  // axis.
  const double polar = volume * radius * radius * (2 + std::cos(turn)) / 6;
  const double lateral = polar / 2 + volume * height * height / 12;
  const MassProperties got = mass_properties(mesh_of(prism_soup(6, 2, 1.5F)));
  const Real tolerance = 10 * rounding * static_cast<Real>(polar);  // the corners are rounded too
  EXPECT_NEAR(got.volume, volume, tolerance);
  expect_near(got.unit_inertia, diagonal(Real(lateral), Real(lateral), Real(polar)), tolerance);
}

TEST(MassProperties, IcospheresApproachTheBallFourTimesCloserEachTime) {
  const double ball = 4.0 / 3 * double(pi);
  double last_error = ball - mass_properties(mesh_of(icosphere_soup(1, 1))).volume;
  for (int subdivisions = 2; subdivisions <= 4; ++subdivisions) {
    const MassProperties got = mass_properties(mesh_of(icosphere_soup(subdivisions, 1)));
    const double error = ball - got.volume;
    // The error of chords is proportional to the square of their length, which halves.
    EXPECT_NEAR(last_error / error, 4, 0.3) << subdivisions;
    // 2/5·V·r² of a ball, reduced by at most three times that relative error, because r² shrinks
    // too.
    EXPECT_NEAR(got.unit_inertia(0, 0), 0.4 * ball, 3 * error) << subdivisions;
    last_error = error;
  }
}

class Covariance : public testing::Test {
 protected:
  const HalfEdgeMesh mesh = mesh_of(pyramid_soup(5, 1, 2));
  const MassProperties original = mass_properties(mesh);
};

TEST_F(Covariance, TranslationMovesTheCentroidOnly) {
  const Vec3 shift(10, -20, 40);
  const MassProperties got =
      mass_properties(mapped(mesh, [&](const Vec3& v) { return v + shift; }));
  // Adding 40 m rounds the vertices themselves to 2⁻¹⁹ m.
  const Real moved = Real(1e-5);
  EXPECT_NEAR(got.volume, original.volume, moved);
  EXPECT_LE((got.centroid - original.centroid - shift).norm(), moved);
  expect_near(got.unit_inertia, original.unit_inertia, moved);
}

TEST_F(Covariance, RotationTurnsTheInertia) {
  const Quat q = rotation_exp({0.3F, -1.1F, 0.7F});
  const MassProperties got = mass_properties(mapped(mesh, [&](const Vec3& v) { return q * v; }));
  const Mat3 r = q.toRotationMatrix();
  EXPECT_NEAR(got.volume, original.volume, 10 * rounding);
  EXPECT_LE((got.centroid - q * original.centroid).norm(), 10 * rounding);
  expect_near(got.unit_inertia, r * original.unit_inertia * r.transpose(), 10 * rounding);
}

TEST_F(Covariance, ScaleEntersInItsThirdAndFifthPower) {
  // Powers of two cause no rounding.
  const MassProperties got =
      mass_properties(mapped(mesh, [](const Vec3& v) { return Vec3(v / 64); }));
  EXPECT_EQ(got.volume, original.volume / (1 << 18));
  EXPECT_EQ(got.centroid, original.centroid / 64);
  EXPECT_EQ(got.unit_inertia, original.unit_inertia / (1 << 30));
}

TEST_F(Covariance, AMirroredMeshHasNegativeVolume) {
  const MassProperties got =
      mass_properties(mapped(mesh, [](const Vec3& v) { return Vec3(-v.x(), v.y(), v.z()); }));
  EXPECT_EQ(got.volume, -original.volume);
}

TEST(MassProperties, MergedFacesGiveTheSame) {
  const HalfEdgeMesh triangles = mesh_of(prism_soup(32, 1, 0.5F));
  const MassProperties split = mass_properties(triangles);
  const MassProperties merged = mass_properties(merge_coplanar_faces(triangles));
  EXPECT_NEAR(merged.volume, split.volume, 4 * rounding);
  expect_near(merged.unit_inertia, split.unit_inertia, 4 * rounding);
}

}  // namespace
}  // namespace cs550::test
