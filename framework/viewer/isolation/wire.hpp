#pragma once
/// @file wire.hpp
/// Values as bytes, from a process to its copy: both have the same layout of structs.

#include <cereal/archives/binary.hpp>
#include <cereal/types/memory.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <sstream>
#include <string>

namespace cs550::viewer {

/// Whether a type holds no pointers, so that its bytes are its value. Specialised beside each type.
template <class T>
inline constexpr bool is_plain = false;

/// Says it of some types.
#define CS550_PLAIN(type) \
  template <>             \
  inline constexpr bool is_plain<type> = true

/// @param value all that it refers to must be plain, or have a serialize()
template <class Value>
std::string to_bytes(const Value& value) {
  std::ostringstream stream;
  cereal::BinaryOutputArchive archive(stream);
  archive(value);
  return stream.str();
}

/// What to_bytes() was given.
template <class Value>
Value from_bytes(const std::string& bytes) {
  std::istringstream stream(bytes);
  cereal::BinaryInputArchive archive(stream);
  Value value;
  archive(value);
  return value;
}

}  // namespace cs550::viewer

namespace cereal {

/// Found by argument-dependent lookup: the archive belongs to cereal.
template <class Archive, class T>
requires cs550::viewer::is_plain<T>
void serialize(Archive& archive, T& value) {
  archive(binary_data(reinterpret_cast<char*>(&value), sizeof value));
}

}  // namespace cereal
