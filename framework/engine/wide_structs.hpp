#pragma once
/// @file wide_structs.hpp
/// Members of four structs as wide numbers, one struct in each lane.
///
/// Members are addressed by pointers to members: the compiler checks their names and types and,
/// once everything is inlined, knows where each of them is.

#include <array>
#include <cstddef>
#include <cstring>

#include "engine/lanes.hpp"

namespace cs550 {

/// The structs that fill the lanes.
template <class T>
using PerLane = std::array<T*, lane_count>;

/// One number of each struct.
template <class T>
WideReal gather(const PerLane<T>& structs, Real T::*member) {
  return WideReal{structs[0]->*member, structs[1]->*member, structs[2]->*member,
                  structs[3]->*member};
}
template <class T, class Vector>
WideReal gather(const PerLane<T>& structs, Vector T::*member, Index i) {
  return WideReal{(structs[0]->*member)[i], (structs[1]->*member)[i], (structs[2]->*member)[i],
                  (structs[3]->*member)[i]};
}

/// `count` consecutive Reals of each struct, transposed into wide ones. Four lanes of four numbers
/// at a time are much faster than numbers one by one.
template <class T, std::size_t count>
class WideReals {
 public:
  /// @param first the member that the Reals begin with
  template <class Member>
  WideReals(const PerLane<T>& structs, Member T::*first)
      : layout_(*structs[0]), first_(bytes_before(first)) {
    for (std::size_t i = 0; i + lane_count <= count; i += lane_count) read(structs, i);
    if (count % lane_count != 0) read(structs, count - lane_count);
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

  void read(const PerLane<T>& structs, std::size_t i) {
    WideReal w[lane_count];
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const auto* item = reinterpret_cast<const std::byte*>(structs[lane]);
      std::memcpy(&w[lane], item + first_ + i * sizeof(Real), sizeof w[lane]);
    }
    transpose(w[0], w[1], w[2], w[3]);
    for (std::size_t k = 0; k < lane_count; ++k) reals_[i + k] = w[k];
  }

  const T& layout_;    ///< any of the structs
  std::size_t first_;  ///< byte
  std::array<WideReal, count> reals_;
};

}  // namespace cs550
