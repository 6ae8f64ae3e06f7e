#include "cs550/primitives.hpp"

#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>

namespace cs550 {
namespace {

constexpr double two_pi = 6.283185307179586476925;

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

bool is_positive(Real length) { return std::isfinite(length) && length > 0; }

void require_polygon(int sides, Real radius) {
  require(sides >= 3 && sides <= 10000, "a regular polygon needs from 3 to 10,000 sides");
  require(is_positive(radius), "a regular polygon needs a positive, finite radius");
}

/// The corners of a regular polygon about the z axis, counter-clockwise seen from above.
std::vector<Vec3> ring(int sides, Real radius, Real z) {
  std::vector<Vec3> points;
  for (int i = 0; i < sides; ++i) {
    const double angle = two_pi * i / sides;
    points.emplace_back(static_cast<Real>(radius * std::cos(angle)),
                        static_cast<Real>(radius * std::sin(angle)), z);
  }
  return points;
}

/// Splits a convex polygon into a fan of triangles.
void add_polygon(TriangleSoup& soup, const std::vector<Index>& corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    soup.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
}

std::vector<Index> counting(Index first, Index count, Index step) {
  std::vector<Index> numbers;
  numbers.reserve(count);
  for (Index i = 0; i < count; ++i) numbers.push_back(first + i * step);
  return numbers;
}

/// The twelve points (0, ±1, ±φ) and their cyclic shifts; any three at mutual distance 2 are a face.
TriangleSoup icosahedron() {
  const Real golden = (1 + std::sqrt(Real(5))) / 2;
  TriangleSoup soup;
  for (const Real a : {-1, 1}) {
    for (const Real b : {-golden, golden}) {
      soup.vertices.insert(soup.vertices.end(), {{0, a, b}, {a, b, 0}, {b, 0, a}});
    }
  }
  const auto point = [&](Index v) -> const Vec3& { return soup.vertices[v]; };
  // Points that are not neighbours are at least 2·φ apart.
  const auto adjacent = [&](Index u, Index v) { return (point(u) - point(v)).norm() < Real(2.5); };
  for (Index u = 0; u < 12; ++u) {
    for (Index v = u + 1; v < 12; ++v) {
      for (Index w = v + 1; w < 12; ++w) {
        if (!adjacent(u, v) || !adjacent(v, w) || !adjacent(w, u)) continue;
        const bool outward = point(u).dot(point(v).cross(point(w))) > 0;
        soup.triangles.push_back(outward ? Triangle{u, v, w} : Triangle{u, w, v});
      }
    }
  }
  return soup;
}

/// A number in [0, 1) that is the same with every standard library.
double unit_interval(std::mt19937& generator) { return static_cast<double>(generator()) * 0x1p-32; }

}  // namespace

TriangleSoup box_soup(const Vec3& half_extents) {
  require(half_extents.allFinite() && half_extents.minCoeff() > 0,
          "a box needs positive, finite half extents");
  TriangleSoup soup;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    soup.vertices.push_back(signs.cwiseProduct(half_extents));
  }
  add_polygon(soup, {0, 4, 6, 2});  // −x
  add_polygon(soup, {1, 3, 7, 5});  // +x
  add_polygon(soup, {0, 1, 5, 4});  // −y
  add_polygon(soup, {2, 6, 7, 3});  // +y
  add_polygon(soup, {0, 2, 3, 1});  // −z
  add_polygon(soup, {4, 5, 7, 6});  // +z
  return soup;
}

TriangleSoup tetrahedron_soup(Real side) {
  require(is_positive(side), "a tetrahedron needs a positive, finite side");
  return {{{0, 0, 0}, {side, 0, 0}, {0, side, 0}, {0, 0, side}},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

TriangleSoup prism_soup(int sides, Real radius, Real half_height) {
  require_polygon(sides, radius);
  require(is_positive(half_height), "a prism needs a positive, finite half height");
  TriangleSoup soup{ring(sides, radius, -half_height), {}};
  const std::vector<Vec3> top = ring(sides, radius, half_height);
  soup.vertices.insert(soup.vertices.end(), top.begin(), top.end());

  add_polygon(soup, counting(sides - 1, sides, -1));
  add_polygon(soup, counting(sides, sides, 1));
  for (Index i = 0; i < sides; ++i) {
    const Index next = (i + 1) % sides;
    add_polygon(soup, {i, next, next + sides, i + sides});
  }
  return soup;
}

TriangleSoup pyramid_soup(int sides, Real radius, Real height) {
  require_polygon(sides, radius);
  require(is_positive(height), "a pyramid needs a positive, finite height");
  TriangleSoup soup{ring(sides, radius, 0), {}};
  const Index apex = sides;
  soup.vertices.emplace_back(0, 0, height);

  add_polygon(soup, counting(sides - 1, sides, -1));
  for (Index i = 0; i < sides; ++i) add_polygon(soup, {i, (i + 1) % sides, apex});
  return soup;
}

TriangleSoup split_at_middles(const TriangleSoup& coarse) {
  TriangleSoup fine{coarse.vertices, {}};
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [entry, is_new] = middles.try_emplace(std::minmax(a, b), fine.vertices.size());
    if (is_new) fine.vertices.push_back(Real(0.5) * (coarse.vertices[a] + coarse.vertices[b]));
    return entry->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const Index ab = middle(a, b);
    const Index bc = middle(b, c);
    const Index ca = middle(c, a);
    fine.triangles.insert(fine.triangles.end(),
                          {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return fine;
}

TriangleSoup icosphere_soup(int subdivisions, Real radius) {
  require(subdivisions >= 0 && subdivisions <= 8, "an icosphere needs from 0 to 8 subdivisions");
  require(is_positive(radius), "an icosphere needs a positive, finite radius");
  TriangleSoup soup = icosahedron();
  for (Vec3& vertex : soup.vertices) vertex.normalize();
  for (int i = 0; i < subdivisions; ++i) {
    const std::size_t kept = soup.vertices.size();
    soup = split_at_middles(soup);
    for (std::size_t v = kept; v < soup.vertices.size(); ++v) soup.vertices[v].normalize();
  }
  for (Vec3& vertex : soup.vertices) vertex *= radius;
  return soup;
}

std::vector<Vec3> random_sphere_points(int count, std::uint32_t seed) {
  std::mt19937 generator(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    // Archimedes: slices of a sphere that are equally high have equal areas.
    const double z = 2 * unit_interval(generator) - 1;
    const double angle = two_pi * unit_interval(generator);
    const double r = std::sqrt(1 - z * z);
    points.emplace_back(static_cast<Real>(r * std::cos(angle)),
                        static_cast<Real>(r * std::sin(angle)), static_cast<Real>(z));
  }
  return points;
}

}  // namespace cs550
