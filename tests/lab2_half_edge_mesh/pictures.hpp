#pragma once
/// @file pictures.hpp
/// Pictures of failed tests of lab 2.

#include <string>

#include "cs550/mesh_validation.hpp"
#include "drawing/mesh_drawing.hpp"
#include "helpers/picture.hpp"
#include "lab2_half_edge_mesh/solids.hpp"

namespace cs550::test {

/// A mesh with the element that violates an invariant.
inline std::string defect_picture(const HalfEdgeMesh& mesh, const MeshDefect& defect) {
  const auto lit = [&](MeshElement element) {
    return std::span(&defect.index, defect.element == element ? 1U : 0U);
  };
  drawing::Drawing drawing =
      drawing::draw_mesh_fault(mesh, defect.sentence, lit(MeshElement::Face),
                               lit(MeshElement::HalfEdge), lit(MeshElement::Vertex));
  drawing.title = "Got: the mesh with what validate() objects to";
  return side_by_side("A mesh that breaks a promise", {drawing::Scene{drawing, {}}});
}

/// A mesh before and after merging.
inline std::string merge_picture(const HalfEdgeMesh& before, const HalfEdgeMesh& after) {
  drawing::MeshStyle style;
  style.edge_width = 2;
  drawing::MeshStyle got = style;
  got.role = drawing::Role::Got;
  drawing::Drawing given = drawing::draw_mesh(before, style);
  given.title = "Given: " + std::to_string(before.face_count()) + " faces";
  drawing::Drawing merged = drawing::draw_mesh(after, got);
  merged.title = "Got: " + std::to_string(after.face_count()) + " faces after merging";
  return side_by_side("Merging coplanar faces",
                      {drawing::Scene{given, {}}, drawing::Scene{merged, {}}});
}

/// Triangles with the elements of an issue, beside the expected elements.
/// @param expected highlighted beside the issue; @param words the error, as a sentence
inline std::string issue_picture(const TriangleSoup& soup, const MeshIssue& expected,
                                 const std::string& words, const MeshIssue& got) {
  drawing::Drawing wanted = drawing::draw_triangles(soup.vertices, soup.triangles, expected);
  wanted.title = words;
  drawing::Drawing named = drawing::draw_triangles(soup.vertices, soup.triangles, got);
  named.title = describe(got);
  return expected_beside_got("What is wrong with these triangles", wanted, named);
}

}  // namespace cs550::test
