#include "viewer/render/solid_mesh.hpp"

#include <vector>

namespace cs550::viewer {
namespace {

/// A corner of a triangle from a face's middle to one of its edges.
struct Corner {
  Vec3 position;
  Vec3 normal;
  float height;  ///< distance from the edge (m): where it is small the edge is drawn
  float depth;   ///< the height at the middle: how large the face is
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

std::vector<Corner> triangulate(const HalfEdgeMesh& mesh) {
  std::vector<Corner> corners;
  corners.reserve(3 * mesh.edges.size());
  for (Index face = 0; face < mesh.face_count(); ++face) {
    const Vec3& normal = mesh.face(face).plane.normal;
    const Vec3 center = middle(mesh, face);
    for (const Index e : face_edges(mesh, face)) {
      const Vec3& start = mesh.vertex(mesh.origin(e));
      const Vec3& end = mesh.vertex(mesh.edge(e).vertex);
      const Real depth = (center - start).cross((end - start).normalized()).norm();
      corners.push_back({start, normal, 0, depth});
      corners.push_back({end, normal, 0, depth});
      corners.push_back({center, normal, depth, depth});
    }
  }
  return corners;
}

void attribute(GLuint place, GLint floats, GLsizei stride, int offset, GLuint divisor) {
  glEnableVertexAttribArray(place);
  glVertexAttribPointer(place, floats, GL_FLOAT, GL_FALSE, stride,
                        reinterpret_cast<const void*>(static_cast<std::uintptr_t>(offset)));
  glVertexAttribDivisor(place, divisor);
}

}  // namespace

SolidMesh::SolidMesh(const HalfEdgeMesh& mesh) {
  const std::vector<Corner> corners = triangulate(mesh);
  vertex_count_ = static_cast<GLsizei>(corners.size());
  glBindVertexArray(layout_.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(Corner)),
               corners.data(), GL_STATIC_DRAW);
  attribute(0, 3, sizeof(Corner), offsetof(Corner, position), 0);
  attribute(1, 3, sizeof(Corner), offsetof(Corner, normal), 0);
  attribute(2, 2, sizeof(Corner), offsetof(Corner, height), 0);
}

void SolidMesh::draw(const Buffer& instances, int first, int count) const {
  glBindVertexArray(layout_.name());
  glBindBuffer(GL_ARRAY_BUFFER, instances.name());
  constexpr int stride = instance_floats * static_cast<int>(sizeof(float));
  const int start = first * stride;
  attribute(3, 3, stride, start, 1);
  attribute(4, 4, stride, start + 3 * static_cast<int>(sizeof(float)), 1);
  attribute(5, 4, stride, start + 7 * static_cast<int>(sizeof(float)), 1);
  attribute(6, 1, stride, start + 11 * static_cast<int>(sizeof(float)), 1);
  glDrawArraysInstanced(GL_TRIANGLES, 0, vertex_count_, count);
}

}  // namespace cs550::viewer
