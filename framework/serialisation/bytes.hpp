#pragma once
/// @file bytes.hpp
/// Values as bytes (cereal), for another process on the same machine.

#include <string>

#include "serialisation/byte_archive.hpp"

namespace cs550::serialisation {

/// @param value of a type that cereal can archive
template <class Value>
std::string to_bytes(const Value& value) {
  ByteWriter archive;
  archive(value);
  return archive.take();
}

/// Reads what to_bytes() wrote. @param known shapes and meshes that the value may refer to
/// @throws cereal::Exception if the bytes end too early
template <class Value>
Value from_bytes(std::string_view bytes, const ContentRegistry* known = nullptr) {
  ByteReader archive(bytes, known);
  Value value{};
  archive(value);
  return value;
}

}  // namespace cs550::serialisation
