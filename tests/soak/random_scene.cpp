#include "soak/random_scene.hpp"

#include <algorithm>
#include <cmath>

#include "helpers/random.hpp"

namespace cs550::test {
namespace {

using Json = nlohmann::json;

/// Draws what a scene consists of. All lengths are multiples of `unit` (m).
class Draw {
 public:
  explicit Draw(std::uint32_t seed)
      : random_(seed),
        unit_(power_of_ten(-3, 3)),
        mass_digits_(random_.real(0, 6)),
        size_digits_(one_in(4) ? random_.real(0, 3) : 0) {}

  Json scene() {
    const Real gravity = one_in(5) ? 0 : power_of_ten(0, 3);
    Json bodies = Json::array({floor()});
    if (one_in(6)) bodies.push_back(mover());
    const bool naive = one_in(5);
    const bool baumgarte = one_in(3);
    const bool game = one_in(3) && !naive && !baumgarte;  // it is meant for soft contacts
    const int count = random_.integer(1, 16);
    const Real spread = one_in(3) ? Real(0.5) : 4;  // in a third of the scenes all overlap
    for (int i = 0; i < count; ++i) bodies.push_back(body(spread));
    return {{"schema", 1},
            {"steps", 120},
            {"world",
             {{"gravity", {0, 0, -gravity}},
              {"length_unit", unit_},
              {"quality", game ? "game" : "accurate"},
              {"sleeping", one_in(3)},
              {"solver", naive ? "naive" : "constraint"},
              {"contact_model", baumgarte ? "baumgarte" : "soft"}}},
            {"bodies", bodies}};
  }

 private:
  bool one_in(int n) { return random_.integer(1, n) == 1; }
  Real power_of_ten(Real least, Real most) { return std::pow(Real(10), random_.real(least, most)); }
  static Json list(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

  Real friction() {
    const Real choices[] = {0, Real(0.5), 1, 10, 1000};
    return choices[random_.integer(0, 4)];
  }
  Real restitution() { return one_in(2) ? 0 : random_.real(0, 1); }

  Json floor() {
    const Real half = 50 * unit_;
    return {{"kind", "static"},
            {"friction", friction()},
            {"restitution", restitution()},
            {"position", {0, 0, -half / 5}},
            {"shape", {{"kind", "box"}, {"half_extents", {half, half, half / 5}}}}};
  }

  /// A kinematic paddle that turns through the bodies.
  Json mover() {
    return {{"kind", "kinematic"},
            {"friction", friction()},
            {"position", {0, 0, unit_}},
            {"angular_velocity", {0, 0, random_.real(-30, 30)}},
            {"shape", {{"kind", "box"}, {"half_extents", {3 * unit_, unit_ / 10, unit_ / 2}}}}};
  }

  Json body(Real spread) {
    const Vec3 place =
        unit_ * (random_.point_in_box(Vec3::Constant(spread)) + (spread + 1) * Vec3::UnitZ());
    const Quat q = random_.orientation();
    const Real spin = one_in(3) ? random_.real(0, 100) : 0;
    const Vec3 axis = random_.unit_vector();
    return {{"position", list(place)},
            {"orientation", {{"quaternion", {q.w(), q.x(), q.y(), q.z()}}}},
            {"angular_velocity", list(spin * axis)},
            {"friction", friction()},
            {"restitution", restitution()},
            {"mass", mass()},
            {"shape", shape()}};
  }

  /// Within what a scene may say.
  Real mass() {
    return std::clamp(1000 * unit_ * unit_ * unit_, Real(1e-8), Real(1e6)) *
           power_of_ten(0, mass_digits_);
  }

  Json shape() {
    const Real size =
        std::max(unit_ * random_.real(Real(0.3), 1) * power_of_ten(-size_digits_, 0), Real(1e-4));
    switch (random_.integer(0, 5)) {
      case 0:
        return {{"kind", "prism"},
                {"sides", random_.integer(3, 8)},
                {"radius", size},
                {"height", size}};
      case 1:
        return {{"kind", "tetrahedron"}, {"side", size}};
      case 2:
        return {{"kind", "icosphere"}, {"radius", size}, {"subdivisions", random_.integer(0, 2)}};
      case 3:
        return {{"kind", "random_hull"},
                {"vertices", random_.integer(6, 24)},
                {"radius", size},
                {"seed", random_.integer(1, 1000000)}};
      default:
        return {{"kind", "box"}, {"half_extents", {size, thickness(size), thickness(size)}}};
    }
  }

  /// No less than what a scene may say.
  Real thickness(Real size) {
    const Real part = one_in(2) ? random_.real(Real(0.3), 1) : power_of_ten(-3, 0);
    return std::max(part * size, Real(2e-6));
  }

  Random random_;
  Real unit_;
  Real mass_digits_;  ///< masses differ by up to ten to this power
  Real size_digits_;  ///< and sizes by up to ten to this one
};

}  // namespace

Json random_scene(std::uint32_t seed) { return Draw(seed).scene(); }

}  // namespace cs550::test
