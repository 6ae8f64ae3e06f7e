#pragma once
/// @file wide_structs.hpp
/// Members of eight structs as wide numbers, one struct in each lane.
///
/// Members are addressed by pointers to members: the compiler checks their names and types and,
/// once everything is inlined, knows where each of them is.

#include <array>
#include <cstddef>
#include <cstring>

#include "engine/wide_vectors.hpp"

namespace cs550::CS550_LANES {

/// The structs that fill the lanes.
template <class T>
using PerLane = std::array<T*, lane_count>;

/// Four lanes, half of a wide number.
using HalfReal __attribute__((vector_size(4 * sizeof(Real)))) = Real;

#if CS550_LANES_IN_A_REGISTER == 8
/// The first and the last four lanes.
/// @{
inline WideReal join(HalfReal low, HalfReal high) {
  return {{__builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7)}};
}
inline HalfReal low_half(WideReal x) {
  return __builtin_shufflevector(x.part[0], x.part[0], 0, 1, 2, 3);
}
inline HalfReal high_half(WideReal x) {
  return __builtin_shufflevector(x.part[0], x.part[0], 4, 5, 6, 7);
}
/// @}

/// In each half alike: four lanes of those of x, 0 to 3, and of those of y, 8 to 11.
template <int i, int k, int l, int m>
WideReal shuffle(WideReal x, WideReal y) {
  return {{__builtin_shufflevector(x.part[0], y.part[0], i, k, l, m, i + 4, k + 4, l + 4, m + 4)}};
}
inline constexpr int of_second = 8;
#else
inline WideReal join(HalfReal low, HalfReal high) { return {{low, high}}; }
inline HalfReal low_half(WideReal x) { return x.part[0]; }
inline HalfReal high_half(WideReal x) { return x.part[1]; }

template <int i, int k, int l, int m>
WideReal shuffle(WideReal x, WideReal y) {
  return {{__builtin_shufflevector(x.part[0], y.part[0], i, k, l, m),
           __builtin_shufflevector(x.part[1], y.part[1], i, k, l, m)}};
}
inline constexpr int of_second = 4;
#endif

/// Four consecutive Reals of each struct as four wide ones, and back. This is much faster than
/// numbers one by one.
/// @{
struct FourReals {
  WideReal first, second, third, fourth;

  /// @param address where the four Reals of a struct are
  template <class T, class Address>
  static FourReals load(const PerLane<T>& structs, const Address& address) {
    const auto row = [&](std::size_t i) {
      HalfReal low;
      HalfReal high;
      std::memcpy(&low, address(*structs[i]), sizeof low);
      std::memcpy(&high, address(*structs[i + 4]), sizeof high);
      return join(low, high);
    };
    return FourReals{row(0), row(1), row(2), row(3)}.transposed();
  }
  template <class T, class Address>
  void store(const PerLane<T>& structs, const Address& address) const {
    const FourReals rows = transposed();
    const WideReal row[] = {rows.first, rows.second, rows.third, rows.fourth};
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const HalfReal reals = lane < 4 ? low_half(row[lane]) : high_half(row[lane - 4]);
      std::memcpy(address(*structs[lane]), &reals, sizeof reals);
    }
  }

 private:
  /// Rows to columns, in each half by itself.
  FourReals transposed() const {
    const WideReal low01 = shuffle<0, of_second, 1, of_second + 1>(first, second);
    const WideReal low23 = shuffle<0, of_second, 1, of_second + 1>(third, fourth);
    const WideReal high01 = shuffle<2, of_second + 2, 3, of_second + 3>(first, second);
    const WideReal high23 = shuffle<2, of_second + 2, 3, of_second + 3>(third, fourth);
    return {shuffle<0, 1, of_second, of_second + 1>(low01, low23),
            shuffle<2, 3, of_second + 2, of_second + 3>(low01, low23),
            shuffle<0, 1, of_second, of_second + 1>(high01, high23),
            shuffle<2, 3, of_second + 2, of_second + 3>(high01, high23)};
  }
};
/// @}

/// `count` consecutive Reals of each struct as wide ones.
template <class T, std::size_t count>
class WideReals {
 public:
  /// @param first the member that the Reals begin with
  template <class Item, class Member>
  WideReals(const PerLane<Item>& structs, Member T::*first)
      : layout_(*structs[0]), first_(bytes_before(first)) {
    for (std::size_t i = 0; i + 4 <= count; i += 4) read(structs, i);
    if (count % 4 != 0) read(structs, count - 4);
  }

  WideReal operator()(Real T::*member) const { return *find(member); }
  WideVec3 operator()(Vec3 T::*member) const { return vector(find(member)); }
  WideMat2 operator()(Mat2 T::*member) const {
    const WideReal* const m = find(member);
    return {m[0], m[1], m[2], m[3]};
  }
  WideMat3 operator()(Mat3 T::*member) const {
    const WideReal* const m = find(member);
    return {{vector(m), vector(m + 3), vector(m + 6)}};
  }
  /// A member of a struct that is itself a member.
  /// @{
  template <class Inner>
  WideReal operator()(Inner T::*member, Real Inner::*inner) const {
    return *find(member, inner);
  }
  template <class Inner>
  WideVec3 operator()(Inner T::*member, Vec3 Inner::*inner) const {
    return vector(find(member, inner));
  }
  template <class Inner>
  WideQuat operator()(Inner T::*member, Quat Inner::*inner) const {
    const WideReal* const q = find(member, inner);
    return {vector(q), q[3]};
  }
  /// @}

 private:
  template <class Member>
  static std::size_t bytes_between(const T& item, const Member& member) {
    return static_cast<std::size_t>(reinterpret_cast<const std::byte*>(&member) -
                                    reinterpret_cast<const std::byte*>(&item));
  }
  template <class Member>
  std::size_t bytes_before(Member T::*member) const {
    return bytes_between(layout_, layout_.*member);
  }
  const WideReal* at(std::size_t bytes) const { return &reals_[(bytes - first_) / sizeof(Real)]; }
  template <class Member>
  const WideReal* find(Member T::*member) const {
    return at(bytes_before(member));
  }
  template <class Inner, class Member>
  const WideReal* find(Inner T::*member, Member Inner::*inner) const {
    return at(bytes_between(layout_, (layout_.*member).*inner));
  }
  static WideVec3 vector(const WideReal* reals) { return {reals[0], reals[1], reals[2]}; }

  template <class Item>
  void read(const PerLane<Item>& structs, std::size_t i) {
    const FourReals four = FourReals::load(structs, [&](const T& item) {
      return reinterpret_cast<const std::byte*>(&item) + first_ + i * sizeof(Real);
    });
    reals_[i] = four.first;
    reals_[i + 1] = four.second;
    reals_[i + 2] = four.third;
    reals_[i + 3] = four.fourth;
  }

  const T& layout_;    ///< any of the structs
  std::size_t first_;  ///< byte
  std::array<WideReal, count> reals_;
};

}  // namespace cs550::CS550_LANES
