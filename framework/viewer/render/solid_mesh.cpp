#include "viewer/render/solid_mesh.hpp"

#include <vector>

namespace cs550::viewer {
namespace {

/// A corner or the middle of a face.
struct Corner {
  Vec3 position;
  Vec3 normal;
  float height;  ///< 0 on the outline of the face, 1 in its middle
};

Vec3 middle(const HalfEdgeMesh& mesh, Index face) {
  Vec3 sum = Vec3::Zero();
  Real count = 0;
  for (const Index e : face_edges(mesh, face)) {
    sum += mesh.vertex(mesh.edge(e).vertex);
    ++count;
  }
  return sum / count;
}

struct Triangles {
  std::vector<Corner> corners;
  std::vector<std::uint32_t> from_middles;
  std::vector<std::uint32_t> from_corners;
};

Triangles triangulate(const HalfEdgeMesh& mesh) {
  Triangles result;
  for (Index face = 0; face < mesh.face_count(); ++face) {
    const Vec3& normal = mesh.face(face).plane.normal;
    const auto center = static_cast<std::uint32_t>(result.corners.size());
    result.corners.push_back({middle(mesh, face), normal, 1});
    for (const Index e : face_edges(mesh, face)) {
      result.corners.push_back({mesh.vertex(mesh.origin(e)), normal, 0});
    }
    const std::uint32_t first = center + 1;
    const auto end = static_cast<std::uint32_t>(result.corners.size());
    for (std::uint32_t corner = first; corner < end; ++corner) {
      const std::uint32_t next = corner + 1 < end ? corner + 1 : first;
      result.from_middles.insert(result.from_middles.end(), {center, corner, next});
      if (corner > first && next != first) {
        result.from_corners.insert(result.from_corners.end(), {first, corner, next});
      }
    }
  }
  return result;
}

void attribute(GLuint place, GLint floats, GLsizei stride, int offset, GLuint divisor) {
  glEnableVertexAttribArray(place);
  glVertexAttribPointer(place, floats, GL_FLOAT, GL_FALSE, stride,
                        buffer_offset(static_cast<std::uintptr_t>(offset)));
  glVertexAttribDivisor(place, divisor);
}

}  // namespace

SolidMesh::SolidMesh(const HalfEdgeMesh& mesh) {
  const Triangles triangles = triangulate(mesh);
  const std::vector<Corner>& corners = triangles.corners;
  std::vector<std::uint32_t> indices = triangles.from_middles;
  indices.insert(indices.end(), triangles.from_corners.begin(), triangles.from_corners.end());
  index_count_ = static_cast<GLsizei>(triangles.from_middles.size());
  outline_count_ = static_cast<GLsizei>(triangles.from_corners.size());
  glBindVertexArray(layout_.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(Corner)),
               corners.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(),
               GL_STATIC_DRAW);
  attribute(0, 3, sizeof(Corner), offsetof(Corner, position), 0);
  attribute(1, 3, sizeof(Corner), offsetof(Corner, normal), 0);
  attribute(2, 1, sizeof(Corner), offsetof(Corner, height), 0);
}

void SolidMesh::bind(const Buffer& instances, int first) const {
  glBindVertexArray(layout_.name());
  glBindBuffer(GL_ARRAY_BUFFER, instances.name());
  constexpr int stride = instance_floats * static_cast<int>(sizeof(float));
  const int start = first * stride;
  attribute(3, 3, stride, start, 1);
  attribute(4, 4, stride, start + 3 * static_cast<int>(sizeof(float)), 1);
  attribute(5, 4, stride, start + 7 * static_cast<int>(sizeof(float)), 1);
  attribute(6, 1, stride, start + 11 * static_cast<int>(sizeof(float)), 1);
}

void SolidMesh::draw(const Buffer& instances, int first, int count) const {
  bind(instances, first);
  glDrawElementsInstanced(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr, count);
}

void SolidMesh::draw_outline(const Buffer& instances, int first, int count) const {
  bind(instances, first);
  const auto offset = static_cast<std::uintptr_t>(index_count_) * sizeof(std::uint32_t);
  glDrawElementsInstanced(GL_TRIANGLES, outline_count_, GL_UNSIGNED_INT, buffer_offset(offset),
                          count);
}

}  // namespace cs550::viewer
