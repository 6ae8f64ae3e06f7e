#pragma once
/// @file batch.hpp
/// Up to four constraints and their bodies in lanes: read from the arrays, solved, written back.

#include <cstddef>
#include <cstring>
#include <span>

#include "cs550/contact_constraint.hpp"
#include "lanes.hpp"

namespace cs550 {

/// Four structs of which the same four consecutive numbers are moved to and from lanes.
template <class T>
class FourStructs {
 public:
  explicit FourStructs(T* const (&items)[lane_count])
      : items_{items[0], items[1], items[2], items[3]} {}

  /// The four numbers that begin `offset` bytes into each struct.
  void read(std::size_t offset, Lanes& w0, Lanes& w1, Lanes& w2, Lanes& w3) const {
    w0 = load(0, offset);
    w1 = load(1, offset);
    w2 = load(2, offset);
    w3 = load(3, offset);
    transpose(w0, w1, w2, w3);
  }

  void write(std::size_t offset, Lanes w0, Lanes w1, Lanes w2, Lanes w3) const {
    transpose(w0, w1, w2, w3);
    store(0, offset, w0);
    store(1, offset, w1);
    store(2, offset, w2);
    store(3, offset, w3);
  }

 private:
  Lanes load(std::size_t item, std::size_t offset) const {
    Lanes numbers;
    std::memcpy(&numbers, reinterpret_cast<const std::byte*>(items_[item]) + offset,
                sizeof numbers);
    return numbers;
  }
  void store(std::size_t item, std::size_t offset, Lanes numbers) const {
    std::memcpy(reinterpret_cast<std::byte*>(items_[item]) + offset, &numbers, sizeof numbers);
  }

  T* items_[lane_count];
};

// Numbers that are read together lie together; these lines break when the contract moves them apart.
static_assert(offsetof(SolverBody, world_inverse_inertia) == 7 * sizeof(Real));
static_assert(offsetof(SolverBody, delta_rotation) == 19 * sizeof(Real));
static_assert(offsetof(ContactConstraint, separation) ==
              offsetof(ContactConstraint, n) + 12 * sizeof(Real));
static_assert(offsetof(ContactConstraint, normal_mass) ==
              offsetof(ContactConstraint, separation) + 12);
static_assert(offsetof(ContactConstraint, normal_impulse) ==
              offsetof(ContactConstraint, impact_handled) + sizeof(Real));
static_assert(offsetof(ContactConstraint, tangent_impulse) ==
              offsetof(ContactConstraint, impact_handled) + 8);

struct BodyLanes {
  Vec3Lanes v, w;
  Lanes inverse_mass;
  Mat3Lanes inverse_inertia;
  Vec3Lanes delta_position, delta_rotation;

  explicit BodyLanes(const FourStructs<SolverBody>& from) {
    auto& [c0, c1, c2] = inverse_inertia.column;
    Lanes repeated;
    from.read(0, v.x, v.y, v.z, w.x);
    from.read(16, w.y, w.z, inverse_mass, c0.x);
    from.read(32, c0.y, c0.z, c1.x, c1.y);
    from.read(48, c1.z, c2.x, c2.y, c2.z);
    from.read(64, delta_position.x, delta_position.y, delta_position.z, delta_rotation.x);
    from.read(72, repeated, delta_rotation.x, delta_rotation.y, delta_rotation.z);
  }

  void store_velocities(const FourStructs<SolverBody>& to) const {
    to.write(0, v.x, v.y, v.z, w.x);
    to.write(16, w.y, w.z, inverse_mass, inverse_inertia.column[0].x);
  }

  /// SolverBody::apply().
  void apply(const Vec3Lanes& impulse, const Vec3Lanes& r) {
    v = v + inverse_mass * impulse;
    w = w + inverse_inertia * r.cross(impulse);
  }
};

struct ConstraintLanes {
  Vec3Lanes n, u, r_a, r_b;
  Lanes separation, friction, restitution, normal_mass;
  Lanes uu, uv, vu, vv;  ///< tangent_mass, by columns
  Lanes bias_rate, mass_scale, impulse_scale, approach_velocity;
  Lanes impact_handled, normal_impulse;
  Lanes tangent_u, tangent_v;

  explicit ConstraintLanes(const FourStructs<ContactConstraint>& from) {
    constexpr std::size_t geometry = offsetof(ContactConstraint, n);
    from.read(geometry, n.x, n.y, n.z, u.x);
    from.read(geometry + 16, u.y, u.z, r_a.x, r_a.y);
    from.read(geometry + 32, r_a.z, r_b.x, r_b.y, r_b.z);
    from.read(offsetof(ContactConstraint, separation), separation, friction, restitution,
              normal_mass);
    from.read(offsetof(ContactConstraint, tangent_mass), uu, vu, uv, vv);
    from.read(offsetof(ContactConstraint, softness), bias_rate, mass_scale, impulse_scale,
              approach_velocity);
    from.read(offsetof(ContactConstraint, impact_handled), impact_handled, normal_impulse,
              tangent_u, tangent_v);
  }

  void store_impulses(const FourStructs<ContactConstraint>& to) const {
    to.write(offsetof(ContactConstraint, impact_handled), impact_handled, normal_impulse, tangent_u,
             tangent_v);
  }
};

}  // namespace cs550
