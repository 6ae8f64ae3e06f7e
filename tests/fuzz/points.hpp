#pragma once
/// @file points.hpp
/// Points made of a fuzzer's bytes.

#include <fuzzer/FuzzedDataProvider.h>

#include <cstdint>
#include <vector>

#include "cs550/math.hpp"

namespace cs550::fuzz {

/// Up to `most` points. Half of the inputs have whole coordinates, so that points coincide and faces
/// are coplanar. The others have any floats: tiny, huge, infinite, not a number.
inline std::vector<Vec3> take_points(FuzzedDataProvider& bytes, int most) {
  const bool whole = bytes.ConsumeBool();
  const auto coordinate = [&]() -> Real {
    if (whole) return static_cast<Real>(bytes.ConsumeIntegral<std::int8_t>());
    return bytes.ConsumeFloatingPoint<Real>();
  };
  const int count = bytes.ConsumeIntegralInRange(0, most);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const Real x = coordinate();
    const Real y = coordinate();
    const Real z = coordinate();
    points.emplace_back(x, y, z);
  }
  return points;
}

}  // namespace cs550::fuzz
