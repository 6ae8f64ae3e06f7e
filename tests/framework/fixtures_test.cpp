#include "helpers/fixtures.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "cs550/mesh_io.hpp"
#include "cs550/mesh_validation.hpp"
#include "helpers/recorded_meshes.hpp"

namespace cs550::test {
namespace {

std::string recorded_bytes(const std::string& name) {
  std::ifstream file(fixture_file(name));
  std::stringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

TEST(Fixtures, RecordingAgainGivesTheSameBytes) {
  for (const auto& [name, mesh] : record_meshes()) {
    // Not EXPECT_EQ, which would print two meshes.
    EXPECT_TRUE(recorded_bytes(name) == to_json(mesh))
        << name << " differs: build and run generate_fixtures, and say why in the commit";
  }
}

TEST(Fixtures, AllButTheTwinPeaksAreShapes) {
  for (const auto& [name, mesh] : record_meshes()) {
    if (name == "twin_peaks") continue;
    EXPECT_NE(fixture_shape(name), nullptr) << name;
    EXPECT_EQ(fixture_shape(name), fixture_shape(name)) << "shared";
  }
}

TEST(Fixtures, FaceAndVertexCountsAreThoseOfTheSolids) {
  const struct {
    const char* name;
    Index vertices, faces;
  } solids[] = {
      {"cube", 8, 6},           {"triangulated_cube", 8, 12},  {"corner_tetrahedron", 4, 4},
      {"sliver", 4, 4},         {"regular_tetrahedron", 4, 4}, {"prism3", 6, 5},
      {"prism6", 12, 8},        {"prism32", 64, 34},           {"pyramid4", 5, 5},
      {"dodecahedron", 20, 12}, {"icosphere0", 12, 20},        {"icosphere1", 42, 80},
      {"icosphere2", 162, 320}, {"icosphere3", 642, 1280}};
  for (const auto& solid : solids) {
    EXPECT_EQ(fixture_mesh(solid.name).vertex_count(), solid.vertices) << solid.name;
    EXPECT_EQ(fixture_mesh(solid.name).face_count(), solid.faces) << solid.name;
  }
}

TEST(Fixtures, RandomHullsHaveAllTheirPointsAsVertices) {
  for (int count = 8; count <= 256; count *= 2) {
    EXPECT_EQ(fixture_mesh("hull" + std::to_string(count)).vertex_count(), count);
  }
}

TEST(Fixtures, TwinPeaksIsClosedAndNotConvex) {
  const HalfEdgeMesh& mesh = fixture_mesh("twin_peaks");
  const auto defect = validate(mesh);
  ASSERT_TRUE(defect);
  EXPECT_NE(defect->sentence.find("not convex"), std::string::npos) << defect->sentence;
  EXPECT_THROW(fixture_shape("twin_peaks"), std::runtime_error);
}

TEST(Fixtures, TwinPeaksHasTheLocalMaximumThatItPromises) {
  const HalfEdgeMesh& mesh = fixture_mesh("twin_peaks");
  for (Index e : vertex_edges(mesh, 6)) {
    EXPECT_LT(mesh.vertex(mesh.edge(e).vertex).z(), mesh.vertex(6).z());
  }
  EXPECT_EQ(mesh.vertex(6).z(), 1);
  EXPECT_EQ(mesh.vertex(7).z(), 2);
}

TEST(Fixtures, AnUnknownNameIsRefusedByName) {
  try {
    fixture_mesh("no_such_shape");
    FAIL() << "found a mesh";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("no_such_shape"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace cs550::test
