#pragma once
/// @file wide_vectors.hpp
/// Vectors, matrices and quaternions of wide numbers. Operations keep the order in which Eigen
/// evaluates them, so that each lane holds the bits of the teaching form.

#include "engine/lanes.hpp"

namespace cs550::CS550_LANES {

struct WideVec3 {
  WideReal x, y, z;

  WideReal dot(const WideVec3& o) const { return x * o.x + (y * o.y + z * o.z); }
  WideVec3 cross(const WideVec3& o) const {
    return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x};
  }
};

inline WideVec3 operator+(const WideVec3& a, const WideVec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline WideVec3 operator-(const WideVec3& a, const WideVec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline WideVec3 operator-(const WideVec3& a) { return {-a.x, -a.y, -a.z}; }
inline WideVec3 operator*(WideReal s, const WideVec3& a) { return {s * a.x, s * a.y, s * a.z}; }

/// Elements in the order in which Eigen stores them, column by column.
struct WideMat2 {
  WideReal uu, vu, uv, vv;
};

struct WideMat3 {
  WideVec3 column[3];

  WideVec3 operator*(const WideVec3& a) const {
    const auto& [c0, c1, c2] = column;
    return {c0.x * a.x + (c1.x * a.y + c2.x * a.z), c0.y * a.x + (c1.y * a.y + c2.y * a.z),
            c0.z * a.x + (c1.z * a.y + c2.z * a.z)};
  }
  WideMat3 operator*(const WideMat3& m) const {
    return {{*this * m.column[0], *this * m.column[1], *this * m.column[2]}};
  }
  WideMat3 transpose() const {
    const auto& [c0, c1, c2] = column;
    return {{{c0.x, c1.x, c2.x}, {c0.y, c1.y, c2.y}, {c0.z, c1.z, c2.z}}};
  }
};

struct WideQuat {
  WideVec3 vec;
  WideReal w;

  WideQuat conjugate() const { return {-vec, w}; }

  /// Rotates a vector.
  WideVec3 operator*(const WideVec3& a) const {
    const WideVec3 half = vec.cross(a);
    const WideVec3 uv = half + half;
    return a + w * uv + vec.cross(uv);
  }
  WideQuat operator*(const WideQuat& o) const {
    const WideVec3& a = vec;
    const WideVec3& b = o.vec;
    return {{(a.x * o.w - a.z * b.y) + (a.y * b.z + w * b.x),
             (a.y * o.w - a.x * b.z) + (a.z * b.x + w * b.y),
             (a.z * o.w - a.y * b.x) + (a.x * b.y + w * b.z)},
            (w * o.w - a.x * b.x) - (a.z * b.z + a.y * b.y)};
  }
  /// @pre not zero
  WideQuat normalized() const {
    const WideReal length = square_root((vec.x * vec.x + vec.z * vec.z) + (vec.y * vec.y + w * w));
    return {{vec.x / length, vec.y / length, vec.z / length}, w / length};
  }
  WideMat3 rotation() const {
    const WideReal one = all_lanes(1);
    const WideVec3 t = all_lanes(2) * vec;
    const WideVec3 tw = w * t;
    const WideReal xx = t.x * vec.x;
    const WideReal xy = t.y * vec.x;
    const WideReal xz = t.z * vec.x;
    const WideReal yy = t.y * vec.y;
    const WideReal yz = t.z * vec.y;
    const WideReal zz = t.z * vec.z;
    return {{{one - (yy + zz), xy + tw.z, xz - tw.y},
             {xy - tw.z, one - (xx + zz), yz + tw.x},
             {xz + tw.y, yz - tw.x, one - (xx + yy)}}};
  }
};

}  // namespace cs550::CS550_LANES
