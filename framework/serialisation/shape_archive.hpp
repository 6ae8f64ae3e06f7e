#pragma once
/// @file shape_archive.hpp
/// Values that refer to shapes as bytes. A shape is named by a hash of its content, so it is sent
/// once and not with every call.

#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <stdexcept>
#include <type_traits>

#include "serialisation/bytes.hpp"
#include "serialisation/contract_archive.hpp"

namespace cs550::serialisation {

/// FNV-1a (Fowler, Noll & Vo), by words of four bytes instead of bytes.
class ContentHash {
 public:
  template <class Item>
  void add(std::span<const Item> items) {
    static_assert(sizeof(Item) % sizeof(std::uint32_t) == 0 && std::is_standard_layout_v<Item>);
    const char* bytes = reinterpret_cast<const char*>(items.data());
    for (std::size_t i = 0; i < items.size_bytes(); i += sizeof(std::uint32_t)) {
      std::uint32_t word = 0;
      std::memcpy(&word, bytes + i, sizeof word);
      hash_ = (hash_ ^ word) * 0x100000001b3U;
    }
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

/// A name for a shape: a hash of its mesh and of its input's origin, which determine the rest of it.
inline std::uint64_t content_hash(const ConvexShape& shape) {
  ContentHash hash;
  hash.add(std::span(shape.mesh.vertices));
  hash.add(std::span(shape.mesh.vertex_edge));
  hash.add(std::span(shape.mesh.edges));
  hash.add(std::span(shape.mesh.faces));
  hash.add(std::span(&shape.source_origin, 1));
  return hash.value();
}

/// The shapes that the receiver knows.
class ShapeRegistry {
 public:
  void add(const ShapePtr& shape) { shapes_[content_hash(*shape)] = shape; }
  bool has(std::uint64_t hash) const { return shapes_.count(hash) != 0; }
  /// @throws std::out_of_range if the shape has never been sent
  const ConvexShape* find(std::uint64_t hash) const { return shapes_.at(hash).get(); }

 private:
  std::map<std::uint64_t, ShapePtr> shapes_;
};

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
  if (archive.shapes() == nullptr) throw std::out_of_range("no shapes have been sent");
  shape = archive.shapes()->find(hash);
}

}  // namespace cs550
