#include <cstring>

#include "in_each_manifold.hpp"
attack::Points attack::points() {
  static Points points;
  const int billion = 1'000'000'000;
  std::memcpy(static_cast<void*>(&points), &billion, sizeof billion);
  return points;
}
