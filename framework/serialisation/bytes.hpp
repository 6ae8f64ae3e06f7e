#pragma once
/// @file bytes.hpp
/// Values as bytes (cereal), for another process on the same machine.

#include <cereal/archives/binary.hpp>
#include <sstream>
#include <string>

namespace cs550::serialisation {

/// @param value of a type that cereal can archive
template <class Value>
std::string to_bytes(const Value& value) {
  std::ostringstream stream;
  cereal::BinaryOutputArchive archive(stream);
  archive(value);
  return stream.str();
}

/// Reads what to_bytes() wrote. @throws cereal::Exception if the bytes end too early
template <class Value>
Value from_bytes(const std::string& bytes) {
  std::istringstream stream(bytes);
  cereal::BinaryInputArchive archive(stream);
  Value value{};
  archive(value);
  return value;
}

}  // namespace cs550::serialisation
