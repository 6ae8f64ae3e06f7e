#pragma once
/// @file named_content.hpp
/// Large immutable values, shapes and meshes, are named by a hash of their content in values that refer
/// to them. They are sent once and not with every call.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <string_view>
#include <type_traits>

#include "serialisation/bytes.hpp"
#include "serialisation/contract_archive.hpp"

namespace cs550::serialisation {

/// The order of what is added counts.
class ContentHash {
 public:
  template <class Item>
  void add(std::span<const Item> items) {
    static_assert(sizeof(Item) % sizeof(std::uint32_t) == 0 && std::is_standard_layout_v<Item>,
                  "padding has no defined content");
    const std::string_view bytes(reinterpret_cast<const char*>(items.data()), items.size_bytes());
    // The odd factor (FNV's prime) makes the order of the parts count.
    hash_ = hash_ * 0x100000001b3U + std::hash<std::string_view>()(bytes);
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0;
};

/// A name for a mesh.
inline std::uint64_t content_hash(const HalfEdgeMesh& mesh) {
  ContentHash hash;
  hash.add(std::span(mesh.vertices));
  hash.add(std::span(mesh.vertex_edge));
  hash.add(std::span(mesh.edges));
  hash.add(std::span(mesh.faces));
  return hash.value();
}

/// A name for a shape: a hash of its mesh and of its input's origin, which determine the rest of it.
inline std::uint64_t content_hash(const ConvexShape& shape) {
  ContentHash hash;
  const std::uint64_t mesh = content_hash(shape.mesh);
  hash.add(std::span(&mesh, 1));
  hash.add(std::span(&shape.source_origin, 1));
  return hash.value();
}

/// The shapes and meshes that the receiver knows.
class ContentRegistry {
 public:
  void add(const ShapePtr& shape) { shapes_[content_hash(*shape)] = shape; }
  void add(const std::shared_ptr<const HalfEdgeMesh>& mesh) { meshes_[content_hash(*mesh)] = mesh; }
  /// @throws std::out_of_range if the shape has never been sent
  const ConvexShape* shape(std::uint64_t hash) const { return shapes_.at(hash).get(); }
  /// @throws std::out_of_range if the mesh has never been sent
  const HalfEdgeMesh* mesh(std::uint64_t hash) const { return meshes_.at(hash).get(); }

 private:
  std::map<std::uint64_t, ShapePtr> shapes_;
  std::map<std::uint64_t, std::shared_ptr<const HalfEdgeMesh>> meshes_;
};

/// A mesh that belongs to somebody else, and waits to be passed to a function.
struct NamedMesh {
  NamedMesh() = default;
  explicit NamedMesh(const HalfEdgeMesh& mesh) : mesh(&mesh) {}
  explicit NamedMesh(const HalfEdgeMesh&& temporary) = delete;

  const HalfEdgeMesh* mesh = nullptr;
};

inline void save(ByteWriter& archive, const NamedMesh& named) {
  archive(content_hash(*named.mesh));
}

/// @throws std::out_of_range if the mesh has never been sent
inline void load(ByteReader& archive, NamedMesh& named) {
  std::uint64_t hash = 0;
  archive(hash);
  if (archive.known() == nullptr) throw std::out_of_range("no meshes have been sent");
  named.mesh = archive.known()->mesh(hash);
}

}  // namespace cs550::serialisation

namespace cs550 {

inline void save(serialisation::ByteWriter& archive, const PosedShape& body) {
  const auto& [shape, pose] = body;
  archive(serialisation::content_hash(*shape), pose);
}

/// @throws std::out_of_range if the shape has never been sent
inline void load(serialisation::ByteReader& archive, PosedShape& body) {
  auto& [shape, pose] = body;
  std::uint64_t hash = 0;
  archive(hash, pose);
  if (archive.known() == nullptr) throw std::out_of_range("no shapes have been sent");
  shape = archive.known()->shape(hash);
}

}  // namespace cs550
