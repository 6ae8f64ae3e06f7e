#pragma once
/// @file packed_vector.hpp
/// A vector in one register, loaded and stored as a whole. A Vec3 is stored number by number, and the
/// processor cannot copy it in one go until all three have reached the cache. Operations keep the order
/// in which Eigen evaluates them, so that they leave the same bits.

#include <cmath>

#include "cs550/math.hpp"

namespace cs550::lab5 {

/// x, y, z, and a fourth number without meaning.
using Packed __attribute__((vector_size(4 * sizeof(Real)))) = Real;

inline Packed packed(const Vec3& v) { return Packed{v.x(), v.y(), v.z(), 0}; }
inline Vec3 unpacked(Packed v) { return {v[0], v[1], v[2]}; }

/// The same number in every place.
inline Packed all(Real x) { return x - Packed{}; }

inline Real dot(Packed a, Packed b) {
  const Packed products = a * b;
  return products[0] + (products[1] + products[2]);
}

inline Packed cross(Packed a, Packed b) {
  const auto yzx = [](Packed v) { return __builtin_shufflevector(v, v, 1, 2, 0, 3); };
  const auto zxy = [](Packed v) { return __builtin_shufflevector(v, v, 2, 0, 1, 3); };
  return yzx(a) * zxy(b) - zxy(a) * yzx(b);
}

/// Vec3::normalized().
inline Packed normalized(Packed v) {
  const Real square = dot(v, v);
  return square > 0 ? v / all(std::sqrt(square)) : v;
}

/// A Plane.
struct PackedPlane {
  Packed normal;
  Real offset;

  Real distance(Packed point) const { return dot(normal, point) - offset; }
};

/// A Pose.
class PackedPose {
 public:
  explicit PackedPose(const Pose& pose)
      : position_(packed(pose.position)),
        axis_(packed(pose.orientation.vec())),
        w_(all(pose.orientation.w())) {}

  Packed to_world(Packed point) const { return rotated(axis_, point) + position_; }
  Packed to_body(Packed point) const { return rotated(-axis_, point - position_); }

 private:
  /// By the quaternion of this vector part.
  Packed rotated(Packed axis, Packed v) const {
    const Packed half = cross(axis, v);
    const Packed uv = half + half;
    return v + w_ * uv + cross(axis, uv);
  }

  Packed position_;
  Packed axis_;  ///< the vector part of the quaternion
  Packed w_;     ///< its real part, in every place
};

}  // namespace cs550::lab5
