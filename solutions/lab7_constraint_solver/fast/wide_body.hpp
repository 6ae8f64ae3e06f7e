#pragma once
/// @file wide_body.hpp
/// Up to eight solver bodies, one in each lane.

#include "engine/wide_structs.hpp"

namespace cs550::CS550_LANES {

struct WideBody {
  WideVec3 v, w;
  WideReal inverse_mass;
  WideMat3 inverse_inertia;
  WideVec3 delta_position, delta_rotation;

  template <class Body>
  explicit WideBody(const PerLane<Body>& bodies) : WideBody(AllReals(bodies, &SolverBody::v)) {}

  /// Two blocks of four Reals: v, w, and two that stay as they are.
  void store_velocities(const PerLane<SolverBody>& bodies) const {
    const auto& first_column = inverse_inertia.column[0];
    FourReals{v.x, v.y, v.z, w.x}.store(bodies, [](SolverBody& body) { return body.v.data(); });
    FourReals{w.y, w.z, inverse_mass, first_column.x}.store(
        bodies, [](SolverBody& body) { return body.w.data() + 1; });
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

}  // namespace cs550::CS550_LANES
