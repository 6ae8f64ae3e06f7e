#pragma once
/// @file shape_archive.hpp
/// Values that refer to shapes as bytes. A shape is named by a hash of its content, so it is sent
/// once and not with every call.

#include <cstdint>
#include <map>
#include <sstream>
#include <string>

#include "serialisation/bytes.hpp"
#include "serialisation/contract_archive.hpp"

namespace cs550::serialisation {

/// FNV-1a (Fowler, Noll & Vo) over the bytes of the mesh, which determines the whole shape.
inline std::uint64_t content_hash(const ConvexShape& shape) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char byte : to_bytes(shape.mesh)) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  }
  return hash;
}

/// The shapes that the receiver knows.
class ShapeRegistry {
 public:
  void add(const ShapePtr& shape) { shapes_[content_hash(*shape)] = shape; }
  /// @throws std::out_of_range if the shape has never been sent
  const ConvexShape* find(std::uint64_t hash) const { return shapes_.at(hash).get(); }

 private:
  std::map<std::uint64_t, ShapePtr> shapes_;
};

/// An input archive that can look up the shapes named in its bytes.
struct ShapeInputArchive : cereal::BinaryInputArchive {
  ShapeInputArchive(std::istream& stream, const ShapeRegistry& known)
      : cereal::BinaryInputArchive(stream), shapes(known) {}
  const ShapeRegistry& shapes;
};

/// Reads what to_bytes() wrote. @param shapes those that the value may refer to
template <class Value>
Value from_bytes(const std::string& bytes, const ShapeRegistry& shapes) {
  std::istringstream stream(bytes);
  ShapeInputArchive archive(stream, shapes);
  Value value;
  archive(value);
  return value;
}

}  // namespace cs550::serialisation

namespace cs550 {

template <class Archive>
void save(Archive& archive, const PosedShape& body) {
  const auto& [shape, pose] = body;
  archive(serialisation::content_hash(*shape), pose);
}

/// @throws std::bad_cast if the archive is not a ShapeInputArchive
inline void load(cereal::BinaryInputArchive& archive, PosedShape& body) {
  auto& [shape, pose] = body;
  std::uint64_t hash = 0;
  archive(hash, pose);
  shape = dynamic_cast<const serialisation::ShapeInputArchive&>(archive).shapes.find(hash);
}

}  // namespace cs550
