#include "cs550/math.hpp"

namespace cs550 {

void Bounds::include(const Vec3& point) {
  lower = lower.cwiseMin(point);
  upper = upper.cwiseMax(point);
}

void Bounds::include(const Bounds& other) {
  lower = lower.cwiseMin(other.lower);
  upper = upper.cwiseMax(other.upper);
}

bool Bounds::contains(const Bounds& other) const {
  return (lower.array() <= other.lower.array()).all() &&
         (upper.array() >= other.upper.array()).all();
}

bool Bounds::overlaps(const Bounds& other) const {
  return (lower.array() <= other.upper.array()).all() &&
         (upper.array() >= other.lower.array()).all();
}

Bounds Bounds::expanded(Real margin) const {
  Bounds result = *this;
  result.lower.array() -= margin;
  result.upper.array() += margin;
  return result;
}

Vec3 Bounds::center() const { return Real(0.5) * (lower + upper); }

Vec3 Bounds::extent() const { return upper - lower; }

Real sine(Real angle) { return static_cast<Real>(std::sin(static_cast<double>(angle))); }

Real cosine(Real angle) { return static_cast<Real>(std::cos(static_cast<double>(angle))); }

Quat rotation_exp(const Vec3& v) {
  const Real square = Real(0.25) * v.squaredNorm();  // of half the angle
  Real sinc;                                         // sin(x)/x
  Real cos;
  if (square < Real(0.25)) {
    // Series, which the engine can compute for many bodies at a time. The terms left out are below 2e-8.
    sinc = 1 - square * (Real(1) / 6 - square * (Real(1) / 120 - square * (Real(1) / 5040)));
    cos = 1 - square *
                  (Real(1) / 2 -
                   square * (Real(1) / 24 - square * (Real(1) / 720 - square * (Real(1) / 40320))));
  } else {
    const Real half_angle = std::sqrt(square);
    sinc = sine(half_angle) / half_angle;
    cos = cosine(half_angle);
  }
  const Vec3 axis = (Real(0.5) * sinc) * v;
  return {cos, axis.x(), axis.y(), axis.z()};
}

Vec3 any_perpendicular(const Vec3& n) {
  const Vec3 axis = std::abs(n.x()) < Real(0.6) ? Vec3::UnitX() : Vec3::UnitY();
  return axis.cross(n).normalized();
}

}  // namespace cs550
