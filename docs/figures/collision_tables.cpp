#include <algorithm>
#include <cmath>

#include "cs550/hill_climbing.hpp"
#include "cs550/separating_axis.hpp"
#include "figure.hpp"
#include "sketch.hpp"

namespace cs550::book {
namespace {

/// vertices, visits: brute force, a climb from a random start, a climb from a neighbouring direction's answer
void visits(std::ostream& out) {
  constexpr int directions = 200;
  for (int subdivisions = 0; subdivisions <= 5; ++subdivisions) {
    const TriangleSoup soup = icosphere_soup(subdivisions, 1);
    const HalfEdgeMesh mesh = build_half_edge_mesh(soup.vertices, soup.triangles).mesh;
    Sequence random(7);
    double cold = 0, warm = 0;
    for (int i = 0; i < directions; ++i) {
      const Vec3 direction = random.direction();
      const auto start = static_cast<Index>(random.next() * mesh.vertex_count());
      const Support found = hill_climb(mesh, direction, start);
      const Vec3 turned =
          rotation_exp(Real(2 * M_PI / 180) * direction.cross(random.direction()).normalized()) *
          direction;
      cold += found.visited;
      warm += hill_climb(mesh, turned, found.vertex).visited;
    }
    out << mesh.vertex_count() << ' ' << mesh.vertex_count() << ' ' << cold / directions << ' '
        << warm / directions << '\n';
  }
}

struct Counts {
  double pairs = 0;        ///< of edges
  double crossings = 0;    ///< whose arcs cross
  double face_visits = 0;  ///< dot products of both face queries
};

/// The climbs of a face query, each begun where the last one ended.
double visits_of_faces(const PosedShape& a, const PosedShape& b) {
  double visited = 0;
  Index start = 0;
  for (Index f = 0; f < a.mesh().face_count(); ++f) {
    const Support found = hill_climb(b.mesh(), b.pose.unrotate(-a.plane(f).normal), start);
    visited += found.visited;
    start = found.vertex;
  }
  return visited;
}

Counts count(const PosedShape& a, const PosedShape& b) {
  Counts counts;
  const auto normal = [](const PosedShape& body, Index e) {
    return body.plane(body.mesh().edge(e).face).normal;
  };
  for (Index e = 0; e < a.mesh().edge_count(); e += 2) {
    for (Index f = 0; f < b.mesh().edge_count(); f += 2) {
      ++counts.pairs;
      counts.crossings +=
          is_minkowski_face(normal(a, e), normal(a, e ^ 1), -normal(b, f), -normal(b, f ^ 1));
    }
  }
  counts.face_visits = visits_of_faces(a, b) + visits_of_faces(b, a);
  return counts;
}

constexpr int sizes[] = {8, 12, 16, 24, 32, 48, 64, 96, 128};

/// vertices, pairs, crossings of random hulls, crossings of prisms crossed at 90°, dot products of the face queries
void crossings(std::ostream& out) {
  constexpr int samples = 8;
  for (const int n : sizes) {
    Counts sum;
    Sequence random(11);
    for (std::uint32_t i = 0; i < samples; ++i) {
      const ShapePtr a = random_hull(n, 2 * i + 1), b = random_hull(n, 2 * i + 2);
      const Counts one = count({a.get(), {Vec3::Zero(), random.orientation()}},
                               {b.get(), {Vec3(Real(1.9), 0, 0), random.orientation()}});
      sum.pairs += one.pairs / samples;
      sum.crossings += one.crossings / samples;
      sum.face_visits += one.face_visits / samples;
    }
    // A turn off the axes, so that no two arcs merely touch.
    const ShapePtr prism = shape_of(prism_soup(n / 2, 1, 1));
    const Quat crossed = rotation_exp(Vec3(pi / 2, 0, 0)) * rotation_exp(Vec3(0, 0, Real(0.0137)));
    const Counts worst = count({prism.get(), {}}, {prism.get(), {Vec3(0, 0, 1), crossed}});
    out << n << ' ' << sum.pairs << ' ' << sum.crossings << ' ' << worst.crossings << ' '
        << sum.face_visits << '\n';
  }
}

double distance_of_segments(const Vec3& a0, const Vec3& u, const Vec3& b0, const Vec3& v) {
  double least = HUGE_VAL;
  for (int i = 0; i <= 200; ++i) {
    const Vec3 p = a0 + static_cast<Real>(i / 200.0) * u;
    const Real t = std::clamp((p - b0).dot(v) / v.squaredNorm(), Real(0), Real(1));
    least = std::min(least, static_cast<double>((b0 + t * v - p).norm()));
  }
  return least;
}

/// A beam with an edge on top.
ShapePtr beam() { return shape_of(prism_soup(4, Real(0.3), 2)); }

/// A beam with an edge upward, along y, and one across it with an edge downward.
struct CrossedBeams {
  ShapePtr shape = beam();
  PosedShape a{shape.get(), {Vec3::Zero(), rotation_exp(Vec3(pi / 2, 0, 0))}};
  PosedShape b{
      shape.get(),
      {Vec3::Zero(), rotation_exp(Vec3(0, 0, Real(1.2))) * rotation_exp(Vec3(pi / 2, 0, 0))}};
};

/// height of the upper beam, signed separation of the two edges, their distance
void unsigned_distance(std::ostream& out) {
  CrossedBeams beams;
  beams.b.pose.position.z() = 1;
  const EdgeQuery edges = query_edge_directions(beams.a, beams.b);
  for (int i = 0; i <= 100; ++i) {
    const double gap = 0.3 - 0.6 * i / 100;
    beams.b.pose.position.z() = static_cast<Real>(0.6 + gap);
    const auto start = [](const PosedShape& body, Index e) {
      return body.vertex(body.mesh().origin(e));
    };
    const auto along = [](const PosedShape& body, Index e) {
      return body.pose.rotate(body.mesh().edge_vector(e));
    };
    const Vec3 p = start(beams.a, edges.edge_a), q = start(beams.b, edges.edge_b);
    out << gap << ' ' << edges.axis.dot(q - p) << ' '
        << distance_of_segments(p, along(beams.a, edges.edge_a), q, along(beams.b, edges.edge_b))
        << '\n';
  }
}

/// Whether any pair of edges is left when nearly parallel ones are told by a test.
template <class IsParallel>
bool finds_edges(const PosedShape& a, const PosedShape& b, IsParallel is_parallel) {
  const auto normal = [](const PosedShape& body, Index e) {
    return body.plane(body.mesh().edge(e).face).normal;
  };
  for (Index e = 0; e < a.mesh().edge_count(); e += 2) {
    for (Index f = 0; f < b.mesh().edge_count(); f += 2) {
      const Vec3 u = a.pose.rotate(a.mesh().edge_vector(e)),
                 v = b.pose.rotate(b.mesh().edge_vector(f));
      if (is_minkowski_face(normal(a, e), normal(a, e ^ 1), -normal(b, f), -normal(b, f ^ 1)) &&
          !is_parallel(u, v))
        return true;
    }
  }
  return false;
}

/// size (m), share of pairs with an edge axis: absolute test, relative test
void tolerance(std::ostream& out) {
  constexpr int samples = 200;
  for (int k = -12; k <= 12; ++k) {
    const auto size = static_cast<Real>(std::pow(10.0, k / 4.0));
    const ShapePtr cube = box(Vec3::Constant(size / 2));
    Sequence random(3);
    int absolute = 0, relative = 0;
    for (int i = 0; i < samples; ++i) {
      const Quat tip = rotation_exp(Vec3(pi / 4, 0, 0));
      const Quat across = rotation_exp(Vec3(0, 0, static_cast<Real>(0.5 + 2 * random.next())));
      const PosedShape a{cube.get(), {Vec3::Zero(), tip}};
      const PosedShape b{cube.get(), {Vec3(0, 0, size * Real(1.36)), Quat(across * tip)}};
      absolute += finds_edges(
          a, b, [](const Vec3& u, const Vec3& v) { return u.cross(v).norm() < Real(1e-4); });
      relative += finds_edges(a, b, [](const Vec3& u, const Vec3& v) {
        return u.cross(v).norm() < parallel_sine * u.norm() * v.norm();
      });
    }
    out << size << ' ' << 100.0 * absolute / samples << ' ' << 100.0 * relative / samples << '\n';
  }
}

/// The separation along the chord of the arc of one edge of A.
struct ArcProfile {
  static constexpr int samples = 2000;
  std::vector<double> s;     ///< s(n(t)) at t = i/samples
  std::vector<double> unit;  ///< s(n(t))/|n(t)|
  std::vector<int> kinks;    ///< samples at which B's support vertex changes
};

ArcProfile profile_of(const HalfEdgeMesh& a, Index e, const PosedShape& b) {
  const Vec3& from = a.face(a.edge(e).face).plane.normal;
  const Vec3& to = a.face(a.edge(e ^ 1).face).plane.normal;
  ArcProfile profile;
  Index before = no_index;
  for (int i = 0; i <= ArcProfile::samples; ++i) {
    const Real t = static_cast<Real>(i) / ArcProfile::samples;
    const Vec3 n = (1 - t) * from + t * to;
    const Index vertex = support_brute_force(b.mesh().vertices, -n).vertex;
    const Real s = n.dot(b.vertex(vertex) - a.vertex(a.origin(e)));
    profile.s.push_back(static_cast<double>(s));
    profile.unit.push_back(static_cast<double>(s / n.norm()));
    if (i > 0 && vertex != before) profile.kinks.push_back(i);
    before = vertex;
  }
  return profile;
}

int peak_of(const std::vector<double>& values) {
  return static_cast<int>(std::max_element(values.begin(), values.end()) - values.begin());
}

/// Whether a profile shows what there is to see: kinks far enough from each other, and two curves
/// whose peaks lie at different ones.
bool shows_kinks(const ArcProfile& profile) {
  if (profile.kinks.size() < 4) return false;
  int before = 0;
  for (const int kink : profile.kinks) {
    if (kink - before < ArcProfile::samples / 12) return false;
    before = kink;
  }
  const int first = peak_of(profile.s), second = peak_of(profile.unit);
  return first > profile.kinks[0] && first < profile.kinks.back() && second != first &&
         std::abs(second - first) > ArcProfile::samples / 12 && second < profile.kinks.back();
}

/// t, s(n(t)), s(n(t))/|n(t)|, and in a second block the breakpoints: along the arc of one edge of A
void concave(std::ostream& out) {
  constexpr std::uint32_t tries = 400;
  for (std::uint32_t seed = 1; seed < tries; ++seed) {
    const ShapePtr a = random_hull(6, 2 * seed), b = random_hull(16, 2 * seed + 1);
    const PosedShape body_b{b.get(), {Vec3(Real(1.6), Real(0.9), Real(1.1)), Quat::Identity()}};
    for (Index e = 0; e < a->mesh.edge_count(); e += 2) {
      const ArcProfile profile = profile_of(a->mesh, e, body_b);
      if (!shows_kinks(profile)) continue;
      const auto line = [&](std::size_t i) {
        out << static_cast<double>(i) / ArcProfile::samples << ' ' << profile.s[i] << ' '
            << profile.unit[i] << '\n';
      };
      for (std::size_t i = 0; i < profile.s.size(); i += 10) line(i);
      out << "\n\n";
      for (const int kink : profile.kinks) line(kink);
      return;
    }
  }
}

}  // namespace

std::vector<Table> collision_tables() {
  return {{"visits", visits},
          {"crossings", crossings},
          {"unsigned", unsigned_distance},
          {"tolerance", tolerance},
          {"concave", concave}};
}

}  // namespace cs550::book
