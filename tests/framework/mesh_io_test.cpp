#include "cs550/mesh_io.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "helpers/fixtures.hpp"
#include "helpers/scratch_folder.hpp"

namespace cs550::test {
namespace {

/// A temporary file, deleted after the test.
class MeshFile : public testing::Test {
 protected:
  void write(const std::string& text) { std::ofstream(path) << text; }

  void expect_named(const std::string& error, const std::string& words) {
    EXPECT_NE(error.find(path.filename().string()), std::string::npos) << "'" << error << "'";
    EXPECT_NE(error.find(words), std::string::npos) << "'" << error << "'";
  }

  const ScratchFolder folder;
  const std::filesystem::path path = folder / "mesh";
};

using ObjFile = MeshFile;
using JsonFile = MeshFile;

TEST_F(ObjFile, OfAQuadPyramidIsRead) {
  write(
      "# a comment\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\n"
      "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf -5 -1 -2\n");
  const SoupResult result = load_obj(path);
  EXPECT_EQ(result.error, "");
  ASSERT_EQ(result.soup.vertices.size(), 5U);
  EXPECT_EQ(result.soup.vertices[4], Vec3(0.5F, 0.5F, 1));
  EXPECT_EQ(result.soup.triangles.size(), 6U) << "the quad is split";
  EXPECT_EQ(make_shape(result.soup.vertices, result.soup.triangles).error, "");
}

TEST_F(ObjFile, ThatIsMissingIsNamed) { expect_named(load_obj(path).error, "open"); }

TEST_F(ObjFile, WithoutFacesIsNamed) {
  write("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  expect_named(load_obj(path).error, "no faces");
  write("this is not a mesh\n");
  expect_named(load_obj(path).error, "no faces");
}

TEST_F(ObjFile, ThatNamesMissingVerticesIsRefused) {
  write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  expect_named(load_obj(path).error, "line 4: a face names vertex 9, but the file has 3 vertices");
  write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\ng more\nf 1 2 3\n");
  expect_named(load_obj(path).error, "line 4: a face names vertex 9, but the file has 3 vertices");
  write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n");
  expect_named(load_obj(path).error, "found \"-4\"");
}

/// The parser would skip the first quad when the second group begins, and split a hexagon whose corners it does
/// not know.
TEST_F(ObjFile, WithFacesBeforeTheirVerticesLosesNone) {
  write(
      "g top\nf 1 2 3 4\ng rest\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\n"
      "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
  expect_named(load_obj(path).error, "line 2: a face comes before its vertices");
  const std::string vertices = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nv -1 1 0\n";
  for (const char* begin : {"g rest\n", "o rest\n", " g \n"}) {
    write("g top\nf 1 2 3 4 5 6\n" + (begin + vertices) + "f 1 2 3\n");
    expect_named(load_obj(path).error, "line 2: a face comes before its vertices");
  }
  write("f 1 2 3 4\ng more\nf 1 2 3 6\ng rest\n" + vertices);
  expect_named(load_obj(path).error, "line 1: a face comes before its vertices");
  // Without the name of a material a group ends, too, if a library was named.
  write("mtllib a.mtl\nf 1 2 3 4\nusemtl\n" + vertices + "f 1 2 3\n");
  expect_named(load_obj(path).error, "line 2: a face comes before its vertices");
  write("mtllib a.mtl\nf 1 2 3 4 5 6\nusemtl\n" + vertices + "f 1 2 3\n");
  expect_named(load_obj(path).error, "line 2: a face comes before its vertices");
}

/// The parser looks at the corners of a face when its group ends, and never at those of a triangle.
TEST_F(ObjFile, MayHaveItsVerticesAfterItsFaces) {
  const std::string vertices = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nv -1 1 0\n";
  write("g top\nf 1 2 3 4 5 6\n" + vertices + "g rest\nf 1 2 3\n");
  EXPECT_EQ(load_obj(path).error, "");
  write("g top\nf 1 2 3\nf 1 3 6\ng rest\n" + vertices + "f 1 6 2\n");
  EXPECT_EQ(load_obj(path).error, "");
  EXPECT_EQ(load_obj(path).soup.triangles.size(), 3U);
  for (const char* no_group : {"g\n", "o\n", "usemtl stone\n", "usemtl\n"}) {
    write("f 1 2 3 4\n" + (no_group + vertices));
    EXPECT_EQ(load_obj(path).error, "");
    EXPECT_EQ(load_obj(path).soup.triangles.size(), 2U);
  }
}

TEST_F(ObjFile, WithNumbersThatWouldBeMisreadIsRefused) {
  for (const std::string word : {"nan", "inf", "1,5", "1e99", "0e3192", "0x1p3", "two", "+-1.5"}) {
    write("v 0 0 0\nv 1 0 " + word + "\nv 0 1 0\nf 1 2 3\n");
    expect_named(load_obj(path).error, "line 2");
    expect_named(load_obj(path).error, "found \"" + word + "\"");
  }
  // One, but ten to the power of 400 overflows where the digits are read.
  write("v 0 0 0\nv 1 0 1" + std::string(400, '0') + "e-400\nv 0 1 0\nf 1 2 3\n");
  expect_named(load_obj(path).error, "line 2: expected a coordinate such as 1.5");
  write("v 0 0\n");
  expect_named(load_obj(path).error, "line 1: expected three coordinates");
}

TEST_F(ObjFile, MayBeginWithAMarkOfUtf8) {
  write("\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const SoupResult result = load_obj(path);
  EXPECT_EQ(result.error, "");
  EXPECT_EQ(result.soup.vertices.size(), 3U);
}

TEST_F(ObjFile, MayHaveExponentsOfThreeDigits) {
  write("v 0 0 0\nv 1.5e+002 0 0\nv 0 1E-003 0\nf 1 2 3\n");
  const SoupResult result = load_obj(path);
  EXPECT_EQ(result.error, "");
  ASSERT_EQ(result.soup.vertices.size(), 3U);
  EXPECT_EQ(result.soup.vertices[1], Vec3(150, 0, 0));
  EXPECT_EQ(result.soup.vertices[2], Vec3(0, 0.001F, 0));
}

TEST_F(ObjFile, WithACarriageReturnInALineIsRefused) {
  write("v 0 0 0\nv 1 0 0\rv 1e39 0 1\nv 0 1 0\nf 1 2 3\n");
  expect_named(load_obj(path).error, "line 2: expected a line feed");
}

/// The parser would see three vertices, and a word in front of the third that it does not know.
TEST_F(ObjFile, WithAControlCharacterIsRefused) {
  for (const char control : {'\f', '\v', '\0', '\x1b', '\x7f'}) {
    write("v 0 0 0\nv 1 0 0\n" + std::string(1, control) + "v 0 1 0\nv 0 0 1\nf 1 2 -1\n");
    expect_named(load_obj(path).error, "line 3: expected plain text, found the control character");
  }
}

TEST_F(ObjFile, MayEndItsLinesAsWindowsDoes) {
  write("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n");
  const SoupResult result = load_obj(path);
  EXPECT_EQ(result.error, "");
  EXPECT_EQ(result.soup.triangles.size(), 1U);
}

/// To the parser, the second line of faces would name vertex 7.
TEST_F(ObjFile, MayHaveACommentInALine) {
  write("v 0 0 0\nv 1 0 0\nv 0 1 0#v\nv 0 0 1 # the top\nf 1 2 3 # the base\nf 1 2 4#f 2 3 7\n");
  const SoupResult result = load_obj(path);
  EXPECT_EQ(result.error, "");
  ASSERT_EQ(result.soup.triangles.size(), 2U);
  EXPECT_EQ(result.soup.triangles[1], (Triangle{0, 1, 3}));
}

/// The file of materials may have no end, as a device does, or belong to somebody else.
TEST_F(ObjFile, IsTheOnlyFileThatIsRead) {
  write("mtllib /dev/zero\nusemtl stone\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const SoupResult result = load_obj(path);
  EXPECT_EQ(result.error, "");
  EXPECT_EQ(result.soup.triangles.size(), 1U);
}

TEST_F(ObjFile, WithAFaceOfTooManyCornersIsRefused) {
  std::string face = "f";
  for (int i = 0; i < 900000; ++i) face += " 1";
  write("v 0 0 0\n" + face + '\n');
  expect_named(load_obj(path).error, "found 900000");
}

TEST_F(ObjFile, WithAVertexNumberedZeroIsNamedWithTheLine) {
  write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 0 2\n");
  expect_named(load_obj(path).error, "line 4");
}

TEST_F(JsonFile, RoundTripKeepsEveryBit) {
  for (const char* name : {"cube", "sliver", "prism32", "hull128", "bunny_hull"}) {
    const HalfEdgeMesh& mesh = fixture_mesh(name);
    write(to_json(mesh));
    const MeshResult result = load_mesh_json(path);
    ASSERT_EQ(result.error, "");
    EXPECT_EQ(result.mesh.vertices, mesh.vertices) << name;
    EXPECT_EQ(to_json(result.mesh), to_json(mesh)) << name;
  }
}

TEST_F(JsonFile, ThatIsMissingIsNamed) { expect_named(load_mesh_json(path).error, "opened"); }

TEST_F(JsonFile, ThatIsNoMeshIsNamed) {
  write("{\"vertices\": [[0, 0");
  expect_named(load_mesh_json(path).error, "JSON");
  write("{\"vertices\": []}");
  expect_named(load_mesh_json(path).error, "vertex_edge");
  write("{\"vertices\": [[0, 1]]}");
  expect_named(load_mesh_json(path).error, "/vertices/0: expected a list of 3 numbers");
  write("[]");
  expect_named(load_mesh_json(path).error, "/: expected an object in braces");
  write("{\"vertices\": " + std::string(100000, '[') + std::string(100000, ']') + "}");
  expect_named(load_mesh_json(path).error, "/vertices/0: expected a list of 3 numbers");
  write("{\"vertices\": [[0, 1, 1e39]]}");
  expect_named(load_mesh_json(path).error, "1e39");
}

/// What a cast to an index would turn into another number.
TEST_F(JsonFile, WithAnIndexThatIsNoneIsNamedWithItsPath) {
  const std::string start = R"({"vertices": [[0, 0, 0]], "vertex_edge": [)";
  for (const std::string index : {"1.7", "1e30", "-1", "4294967296", "\"0\"", "null", "[0]"}) {
    write(fmt::format(R"({}0, {}], "half_edges": [], "faces": []}})", start, index));
    expect_named(load_mesh_json(path).error, "/vertex_edge/1: expected the index of an element");
    write(fmt::format(R"({}0], "half_edges": [[0, 1, 2, 3], [0, {}, 2, 3]], "faces": []}})", start,
                      index));
    expect_named(load_mesh_json(path).error, "/half_edges/1/1: expected the index of an element");
    write(fmt::format(R"({}0], "half_edges": [], "faces": [[{}, 0, 0, 1, 0]]}})", start, index));
    expect_named(load_mesh_json(path).error, "/faces/0/0: expected the index of an element");
  }
  write(start + "0, 1.7], \"half_edges\": [], \"faces\": []}");
  expect_named(load_mesh_json(path).error, "found 1.7");
}

TEST_F(JsonFile, OfABrokenMeshIsNamedWithTheDefect) {
  HalfEdgeMesh mesh = fixture_mesh("cube");
  mesh.vertices[0] *= 2;
  write(to_json(mesh));
  expect_named(load_mesh_json(path).error, "away from its plane");
}

TEST_F(JsonFile, OfAMeshThatIsNotConvexIsTakenOnRequest) {
  write(to_json(fixture_mesh("twin_peaks")));
  expect_named(load_mesh_json(path).error, "not convex");
  EXPECT_EQ(load_mesh_json(path, HUGE_VALF).error, "");
}

}  // namespace
}  // namespace cs550::test
