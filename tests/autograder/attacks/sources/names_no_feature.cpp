#include "in_each_manifold.hpp"
attack::Points attack::points() {
  Points points;
  points.push_back({});
  points.back().feature.bits = 0xf0000000;
  return points;
}
