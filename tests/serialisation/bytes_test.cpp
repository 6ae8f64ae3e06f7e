/// Bytes from a stranger: whatever they are, reading them ends with a value or an exception.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "serialisation/arguments.hpp"

namespace cs550::test {
namespace {

using namespace serialisation;

TEST(Serialisation, BytesThatEndTooEarlyAreRefused) {
  const std::string bytes = to_bytes(std::vector<Index>{1, 2, 3});
  EXPECT_EQ(from_bytes<std::vector<Index>>(bytes).size(), 3U);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(from_bytes<std::vector<Index>>(bytes.substr(0, size)), cereal::Exception);
  }
}

TEST(Serialisation, ASizeBeyondTheBytesIsRefusedBeforeMemoryIsTaken) {
  const std::string bytes = to_bytes(std::numeric_limits<std::uint64_t>::max() / 64);
  EXPECT_THROW(from_bytes<std::vector<Vec3>>(bytes), cereal::Exception);
}

struct CountedItem {
  CountedItem() { ++made; }
  std::array<std::uint8_t, 50> bytes;
  static inline int made = 0;
};

template <class Archive>
void serialize(Archive& archive, CountedItem& item) {
  archive(item.bytes);
}

TEST(Serialisation, ItemsAreMadeOnlyForBytesThatAreThere) {
  const std::string bytes = to_bytes(std::uint64_t{100}) + std::string(100, '\0');
  EXPECT_THROW(from_bytes<std::vector<CountedItem>>(bytes), cereal::Exception);
  EXPECT_LE(CountedItem::made, 3) << "a hundred were announced";
}

TEST(Serialisation, MoreItemsThanFitAreRefused) {
  using Four = StaticVector<Index, 4>;
  EXPECT_THROW(from_bytes<Four>(to_bytes(5) + std::string(100, '\0')), cereal::Exception);
  EXPECT_THROW(from_bytes<Four>(to_bytes(-1) + std::string(100, '\0')), cereal::Exception);
}

TEST(Serialisation, ABoolIsTrueOrFalse) {
  const auto truth = from_bytes<bool>(std::string(1, '\x7f'));
  std::uint8_t byte = 0;
  std::memcpy(&byte, &truth, sizeof byte);
  EXPECT_EQ(byte, 1);
}

TEST(Serialisation, NumbersThatAreNotFiniteAreNoticed) {
  for (const Real number : {Real(1), HUGE_VALF, std::numeric_limits<Real>::quiet_NaN()}) {
    ByteWriter writer;
    writer(Vec3(0, number, 0));
    EXPECT_EQ(writer.has_non_finite(), !std::isfinite(number));
    const std::string bytes = writer.take();
    ByteReader reader(bytes);
    Vec3 read;
    reader(read);
    EXPECT_EQ(reader.has_non_finite(), !std::isfinite(number));
  }
}

void double_it(const int& input, int& output, int* optional, std::span<int> array) {
  output = 2 * input;
  if (optional != nullptr) *optional = 3;
  for (int& number : array) number *= 2;
}

TEST(Serialisation, AnAnswerHoldsTheOutputsAlone) {
  Arguments<const int&, int&, int*, std::span<int>> arguments{4, 0, 0, {5, 6}};
  EXPECT_EQ(answer(double_it, arguments), std::tuple(8, std::optional(3), std::vector{10, 12}));
  std::get<2>(arguments).reset();
  EXPECT_EQ(std::get<1>(answer(double_it, arguments)), std::nullopt);
}

TEST(Serialisation, AnArrayKeepsItsSize) {
  std::vector<int> original(3);
  using Array = Parameter<std::span<int>>;
  EXPECT_THROW(Array::assign(original, {1, 2}), cereal::Exception);
  Array::assign(original, {1, 2, 3});
  EXPECT_EQ(original, (std::vector{1, 2, 3}));
}

}  // namespace
}  // namespace cs550::test
