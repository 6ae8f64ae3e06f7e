#pragma once
/// @file byte_archive.hpp
/// Two cereal archives that write to and read from one string of bytes. They are several times
/// faster than cereal's own, which work on streams, and safe to use on bytes of a stranger: nothing
/// is read past the end, no size exceeds the bytes that are left, and a bool is 0 or 1.

#include <algorithm>
#include <cereal/cereal.hpp>
#include <cereal/types/vector.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace cs550::serialisation {

class ContentRegistry;

/// Appends values to a string.
class ByteWriter : public cereal::OutputArchive<ByteWriter, cereal::AllowEmptyClassElision> {
 public:
  ByteWriter() : OutputArchive(this) {}
  void write(const void* data, std::size_t count) {
    bytes_.append(static_cast<const char*>(data), count);
  }
  /// Several numbers at once.
  template <class Number>
  void numbers(const Number* values, std::size_t count) {
    write(values, count * sizeof(Number));
    for (std::size_t i = 0; i < count; ++i) note(std::isfinite(values[i]));
  }
  std::string take() { return std::move(bytes_); }

  /// Whether a number that was written is NaN or infinite.
  bool has_non_finite() const { return has_non_finite_; }
  void note(bool is_finite) { has_non_finite_ = has_non_finite_ || !is_finite; }

 private:
  std::string bytes_;
  bool has_non_finite_ = false;
};

/// Reads what a ByteWriter wrote. @throws cereal::Exception if the bytes end too early
class ByteReader : public cereal::InputArchive<ByteReader, cereal::AllowEmptyClassElision> {
 public:
  /// @param bytes must outlive the reader
  /// @param known shapes and meshes that the values may refer to
  explicit ByteReader(std::string_view bytes, const ContentRegistry* known = nullptr)
      : InputArchive(this), rest_(bytes), known_(known) {}

  void read(void* data, std::size_t count) {
    if (count > rest_.size()) throw cereal::Exception("the bytes end too early");
    if (count > 0) std::memcpy(data, rest_.data(), count);
    rest_.remove_prefix(count);
  }
  /// Several numbers at once.
  template <class Number>
  void numbers(Number* values, std::size_t count) {
    read(values, count * sizeof(Number));
    for (std::size_t i = 0; i < count; ++i) note(std::isfinite(values[i]));
  }
  /// How many bytes have not been read yet.
  std::size_t left() const { return rest_.size(); }
  const ContentRegistry* known() const { return known_; }

  /// Whether a number that was read is NaN or infinite.
  bool has_non_finite() const { return has_non_finite_; }
  void note(bool is_finite) { has_non_finite_ = has_non_finite_ || !is_finite; }

 private:
  std::string_view rest_;
  const ContentRegistry* known_;
  bool has_non_finite_ = false;
};

template <class Number>
requires std::is_arithmetic_v<Number>
void save(ByteWriter& archive, const Number& number) {
  archive.write(&number, sizeof number);
  if constexpr (std::is_floating_point_v<Number>) archive.note(std::isfinite(number));
}

template <class Number>
requires std::is_arithmetic_v<Number>
void load(ByteReader& archive, Number& number) {
  archive.read(&number, sizeof number);
  if constexpr (std::is_floating_point_v<Number>) archive.note(std::isfinite(number));
}

inline void load(ByteReader& archive, bool& truth) {
  std::uint8_t byte = 0;
  archive.read(&byte, sizeof byte);
  truth = byte != 0;
}

template <class Value>
void serialize(ByteWriter& archive, cereal::NameValuePair<Value>& pair) {
  archive(pair.value);
}
template <class Value>
void serialize(ByteReader& archive, cereal::NameValuePair<Value>& pair) {
  archive(pair.value);
}

template <class Size>
void save(ByteWriter& archive, const cereal::SizeTag<Size>& tag) {
  archive(static_cast<std::uint64_t>(tag.size));
}
template <class Size>
void load(ByteReader& archive, cereal::SizeTag<Size>& tag) {
  std::uint64_t size = 0;
  archive(size);
  if (size > archive.left()) throw cereal::Exception("a size exceeds the bytes that follow");
  tag.size = static_cast<std::remove_reference_t<Size>>(size);
}

/// Not by cereal, which makes all elements before it reads the first: a stranger could announce as many as
/// there are bytes, and each may be much larger.
template <class Item, class Allocator>
requires(!std::is_arithmetic_v<Item>) void load(ByteReader& archive,
                                                std::vector<Item, Allocator>& items) {
  std::size_t size = 0;
  archive(cereal::make_size_tag(size));
  items.clear();
  items.reserve(std::min(size, archive.left() / sizeof(Item)));
  for (std::size_t i = 0; i < size; ++i) archive(items.emplace_back());
}

template <class Data>
void save(ByteWriter& archive, const cereal::BinaryData<Data>& binary) {
  archive.write(binary.data, static_cast<std::size_t>(binary.size));
}
template <class Data>
void load(ByteReader& archive, cereal::BinaryData<Data>& binary) {
  archive.read(binary.data, static_cast<std::size_t>(binary.size));
}

}  // namespace cs550::serialisation

CEREAL_SETUP_ARCHIVE_TRAITS(cs550::serialisation::ByteReader, cs550::serialisation::ByteWriter)
