#pragma once
/// @file batch.hpp
/// Up to four constraints and their bodies, one in each lane: read from the arrays, solved, written
/// back.
///
/// Members are addressed by pointers to members: the compiler checks their names and types and,
/// once everything is inlined, knows where each of them is.

#include <array>
#include <cstddef>
#include <cstring>

#include "cs550/contact_constraint.hpp"
#include "lanes.hpp"

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
  /// A Real of a struct that is itself a member.
  template <class Inner>
  WideReal operator()(Inner T::*member, Real Inner::*inner) const {
    return *at(bytes_between(layout_, (layout_.*member).*inner));
  }

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

struct WideBody {
  WideVec3 v, w;
  WideReal inverse_mass;
  WideMat3 inverse_inertia;
  WideVec3 delta_position, delta_rotation;

  explicit WideBody(const PerLane<SolverBody>& bodies)
      : WideBody(AllReals(bodies, &SolverBody::v)) {}

  void store_velocities(const PerLane<SolverBody>& bodies) const {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      bodies[lane]->v = {v.x[lane], v.y[lane], v.z[lane]};
      bodies[lane]->w = {w.x[lane], w.y[lane], w.z[lane]};
    }
  }

  /// SolverBody::apply().
  void apply(const WideVec3& impulse, const WideVec3& r) {
    v = v + inverse_mass * impulse;
    w = w + inverse_inertia * r.cross(impulse);
  }

 private:
  using AllReals = WideReals<SolverBody, sizeof(SolverBody) / sizeof(Real)>;

  explicit WideBody(const AllReals& body)
      : v(body(&SolverBody::v)),
        w(body(&SolverBody::w)),
        inverse_mass(body(&SolverBody::inverse_mass)),
        inverse_inertia(body(&SolverBody::world_inverse_inertia)),
        delta_position(body(&SolverBody::delta_position)),
        delta_rotation(body(&SolverBody::delta_rotation)) {}
};

struct WideConstraint {
  using C = ContactConstraint;

  WideVec3 n, u, r_a, r_b;
  WideReal separation, friction, restitution, normal_mass;
  WideMat2 tangent_mass;
  WideReal bias_rate, mass_scale, impulse_scale, approach_velocity;
  WideReal normal_impulse, tangent_u, tangent_v;

  explicit WideConstraint(const PerLane<C>& constraints)
      : WideConstraint(Constants(constraints, &C::n), constraints) {}

  void store_impulses(const PerLane<C>& constraints) const {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      constraints[lane]->normal_impulse = normal_impulse[lane];
      constraints[lane]->tangent_impulse = {tangent_u[lane], tangent_v[lane]};
    }
  }

 private:
  /// The Reals from n to approach_velocity: what a pass does not change.
  using Constants =
      WideReals<C, (offsetof(C, approach_velocity) - offsetof(C, n)) / sizeof(Real) + 1>;

  WideConstraint(const Constants& constraint, const PerLane<C>& constraints)
      : n(constraint(&C::n)),
        u(constraint(&C::u)),
        r_a(constraint(&C::r_a)),
        r_b(constraint(&C::r_b)),
        separation(constraint(&C::separation)),
        friction(constraint(&C::friction)),
        restitution(constraint(&C::restitution)),
        normal_mass(constraint(&C::normal_mass)),
        tangent_mass(constraint(&C::tangent_mass)),
        bias_rate(constraint(&C::softness, &Softness::bias_rate)),
        mass_scale(constraint(&C::softness, &Softness::mass_scale)),
        impulse_scale(constraint(&C::softness, &Softness::impulse_scale)),
        approach_velocity(constraint(&C::approach_velocity)),
        normal_impulse(gather(constraints, &C::normal_impulse)),
        tangent_u(gather(constraints, &C::tangent_impulse, 0)),
        tangent_v(gather(constraints, &C::tangent_impulse, 1)) {}
};

}  // namespace cs550
