// Prints a hash of the manifolds of many pairs of faces, for shapes of each kind.
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <limits>

#include "cs550/clipping.hpp"
#include "cs550/primitives.hpp"
#include "helpers/random.hpp"

namespace {

using namespace cs550;
using cs550::test::Random;

/// FNV-1a of the bits of numbers.
class Hash {
 public:
  void add(std::uint32_t bits) {
    for (int shift = 0; shift < 32; shift += 8) {
      value_ = (value_ ^ (bits >> shift & 0xff)) * 0x100000001b3;
    }
  }
  void add(Real number) { add(std::bit_cast<std::uint32_t>(number)); }
  void add(const Vec3& vector) {
    for (int i = 0; i < 3; ++i) add(vector[i]);
  }
  void add(const Manifold& manifold) {
    add(manifold.normal);
    add(manifold.tangent);
    for (const ContactPoint& point : manifold.points) {
      add(point.anchor_a);
      add(point.anchor_b);
      add(point.separation);
      add(point.feature.bits);
    }
  }
  unsigned long long value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

class Manifolds {
 public:
  /// Those of both of the best faces.
  void add(const PosedShape& a, const PosedShape& b) {
    SeparatingAxis axis = find_separating_axis(a, b, {}, all);
    for (const AxisFeature face : {AxisFeature::FaceA, AxisFeature::FaceB}) {
      axis.feature = face;
      add(a, b, axis);
    }
  }

  /// With margins that drop points, and with one that keeps all.
  void add(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis) {
    for (const Real margin : {Real(0), Real(0.01) * a.shape->radius, all}) {
      const Manifold manifold = face_manifold(a, b, axis, margin);
      hash_.add(manifold);
      points_ += manifold.points.size();
    }
  }

  void print(const char* shapes) const {
    std::printf("%s: %016llx, %d points\n", shapes, hash_.value(), points_);
  }

 private:
  static constexpr Real all = std::numeric_limits<Real>::max();

  Hash hash_;
  int points_ = 0;
};

ShapePtr shape_of(const TriangleSoup& soup) {
  return make_shape(soup.vertices, soup.triangles).shape;
}

ShapePtr random_hull(int vertices, Random& random) {
  std::vector<Vec3> points(static_cast<std::size_t>(vertices));
  for (Vec3& point : points) point = random.unit_vector();
  return shape_of(convex_hull(points).soup);
}

/// Two shapes in any orientation, from one inside the other to well apart.
void print_random_pairs(const char* name, const ShapePtr& first, const ShapePtr& second) {
  constexpr int pairs = 2000;
  Random random(11);
  Manifolds manifolds;
  for (int i = 0; i < pairs; ++i) {
    const Real distance = random.real(0, Real(1.2) * (first->radius + second->radius));
    const PosedShape a{first.get(), {100 * random.unit_vector(), random.orientation()}};
    manifolds.add(a, {second.get(),
                      {a.pose.position + distance * random.unit_vector(), random.orientation()}});
  }
  manifolds.print(name);
}

/// A small box on a large one, moved over a side plane number by number: at one of them a corner is in the plane to the
/// last bit. First an edge of the small box, then a corner in whose plane the box is cut in halves.
void print_corners_in_planes(const ShapePtr& large, const ShapePtr& small) {
  constexpr int numbers = 400;
  struct Placement {
    Real turn;      ///< about the vertical
    Real offset_x;  ///< of the corners from the middle of the small box
  };
  const Real half = small->mesh.vertex(0).cwiseAbs().x();
  Manifolds manifolds;
  PosedShape below{large.get(), {}};
  PosedShape above{small.get(), {}};
  for (const Placement& placement : {Placement{0, half}, {0, -half}, {pi / 4, 0}}) {
    above.pose.orientation = rotation_exp(Vec3(0, placement.turn, 0));
    const Real side = large->mesh.vertex(0).cwiseAbs().x() + side_plane_tolerance * small->radius;
    for (const Real sign : {Real(-1), Real(1)}) {
      Real x = sign * (side - placement.offset_x);
      for (int i = 0; i < numbers / 2; ++i) x = std::nextafter(x, -HUGE_VALF);
      for (int i = 0; i < numbers; ++i) {
        above.pose.position = {x, Real(0.99) * (half + Real(0.5)), 0};
        manifolds.add(below, above);
        x = std::nextafter(x, HUGE_VALF);
      }
    }
  }
  manifolds.print("corners in planes");
}

/// The teaching form drops corners whose distance is not a number.
void print_poses_that_are_not_numbers(const ShapePtr& box) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  SeparatingAxis axis;
  axis.feature = AxisFeature::FaceA;
  axis.face_a = {0, 0, 0};
  const PosedShape a{box.get(), {}};
  Manifolds manifolds;
  manifolds.add(a, {box.get(), {Vec3(nan, 0, 0), {1, 0, 0, 0}}}, axis);
  manifolds.add(a, {box.get(), {Vec3(0, 0, 1), {nan, 0, 0, 0}}}, axis);
  manifolds.print("poses that are not numbers");
}

}  // namespace

int main() {
  Random random(7);
  const ShapePtr box = shape_of(box_soup(Vec3::Constant(Real(0.5))));
  const ShapePtr hull = random_hull(32, random);
  print_random_pairs("boxes", box, box);
  print_random_pairs("hulls of 8 and 32 vertices", random_hull(8, random), hull);
  print_random_pairs("hulls of 32 and 128 vertices", hull, random_hull(128, random));
  print_random_pairs("prisms of 100 sides", shape_of(prism_soup(100, 1, Real(0.2))),
                     shape_of(prism_soup(100, Real(0.9), Real(0.3))));
  print_random_pairs("plates", shape_of(box_soup(Vec3(1, Real(0.01), 1))), hull);
  print_random_pairs("grains on blocks", shape_of(box_soup(Vec3::Constant(50))),
                     shape_of(box_soup(Vec3::Constant(Real(0.01)))));
  print_poses_that_are_not_numbers(box);
  print_corners_in_planes(box, shape_of(box_soup(Vec3::Constant(Real(0.3)))));
}
