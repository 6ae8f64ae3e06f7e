#include "benchmarks/stages/hull_pairs.hpp"

#include "cs550/primitives.hpp"

namespace cs550::bench {
namespace {

using test::Random;

constexpr int pair_count = 64;

ShapePtr random_shape(int vertices, std::uint32_t seed) {
  const TriangleSoup soup = vertices == 0 ? box_soup(Vec3::Constant(Real(0.5)))
                                          : convex_hull(random_sphere_points(vertices, seed)).soup;
  return make_shape(soup.vertices, soup.triangles).shape;
}

}  // namespace

HullPairs::HullPairs(int vertices, Real least, Real most) {
  for (std::uint32_t seed = 1; seed <= 8; ++seed) shapes_.push_back(random_shape(vertices, seed));
  Random random(4);
  while (pairs.size() < pair_count) {
    HullPair pair;
    pair.a = {shapes_[random.integer(0, 7)].get(), {Vec3::Zero(), random.orientation()}};
    pair.b = {shapes_[random.integer(0, 7)].get(), {Vec3::Zero(), random.orientation()}};
    const Real distance = random.real(Real(0.5), 3);
    pair.b.pose.position = distance * random.unit_vector();
    pair.hint = find_separating_axis(pair.a, pair.b, {}, margin);
    if (pair.hint.separation > least && pair.hint.separation < most) pairs.push_back(pair);
  }
}

void HullPairs::move() {
  constexpr Real distance = Real(0.002);
  constexpr Real angle = Real(0.2) * pi / 180;
  Random random(91);
  for (HullPair& pair : pairs) {
    pair.b.pose.position += distance * random.unit_vector();
    pair.b.pose.orientation = rotation_exp(angle * random.unit_vector()) * pair.b.pose.orientation;
  }
}

}  // namespace cs550::bench
