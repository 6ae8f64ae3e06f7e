// The ranges of settings and of bodies that world.hpp states: both ends are accepted, the next numbers are not.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "cs550/setting_range.hpp"
#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

constexpr Real beyond_all = std::numeric_limits<Real>::infinity();
constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN();

/// A setting, or a component of one, with its range.
template <class Number>
struct SettingRow {
  const char* name;
  Number least;
  Number most;
  void (*set)(WorldSettings&, Number);
};

constexpr SettingRow<Real> real_settings[] = {
    {"gravity", -1e6F, 1e6F, [](WorldSettings& s, Real x) { s.gravity.x() = x; }},
    {"gravity", -1e6F, 1e6F, [](WorldSettings& s, Real x) { s.gravity.y() = x; }},
    {"gravity", -1e6F, 1e6F, [](WorldSettings& s, Real x) { s.gravity.z() = x; }},
    // 1e-6 is no float, and the nearest one is smaller.
    {"length_unit", 1e-6F, 1e6F, [](WorldSettings& s, Real x) { s.length_unit = x; }},
    {"contact_hertz", 1e-6F, 1e6F, [](WorldSettings& s, Real x) { s.contact_hertz = x; }},
    {"contact_damping_ratio", 0, 1e6F,
     [](WorldSettings& s, Real x) { s.contact_damping_ratio = x; }},
    {"baumgarte", 0, 1, [](WorldSettings& s, Real x) { s.baumgarte = x; }},
    {"slop", 0, 1e6F, [](WorldSettings& s, Real x) { s.slop = x; }},
    {"max_push_speed", 0, 1e6F, [](WorldSettings& s, Real x) { s.max_push_speed = x; }},
    {"restitution_threshold", 0, 1e6F,
     [](WorldSettings& s, Real x) { s.restitution_threshold = x; }},
    {"over_relaxation", 1, 1.9F, [](WorldSettings& s, Real x) { s.over_relaxation = x; }},
    {"rolling_resistance", 0, 1e6F, [](WorldSettings& s, Real x) { s.rolling_resistance = x; }},
};

constexpr SettingRow<int> whole_settings[] = {
    {"substeps", 1, 1000, [](WorldSettings& s, int n) { s.substeps = n; }},
    {"iterations", 0, 1000, [](WorldSettings& s, int n) { s.iterations = n; }},
    {"relax_iterations", 0, 1000, [](WorldSettings& s, int n) { s.relax_iterations = n; }},
    {"restitution_iterations", 0, 1000,
     [](WorldSettings& s, int n) { s.restitution_iterations = n; }},
    {"threads", 1, 16, [](WorldSettings& s, int n) { s.threads = n; }},
};

/// The message with which a world refuses to step; empty if it does not.
template <class Number>
std::string refusal_of_step(const SettingRow<Number>& row, Number value) {
  World world;
  const BodyId box = world.add_body(body_at(unit_box(), {0, 0, 3}));
  row.set(world.settings(), value);
  try {
    world.step(step_length);
    return {};
  } catch (const std::invalid_argument& refused) {
    EXPECT_EQ(world.body(box).pose.position.z(), 3) << "nothing has changed";
    EXPECT_EQ(world.step_count(), 0);
    return refused.what();
  }
}

template <class Number>
void expect_value_refused(const SettingRow<Number>& row, Number value) {
  const std::string beginning = std::string("the setting ") + row.name + " needs ";
  EXPECT_EQ(refusal_of_step(row, value).substr(0, beginning.size()), beginning) << value;
}

template <class Number>
void expect_ends_accepted(const SettingRow<Number>& row) {
  EXPECT_EQ(refusal_of_step(row, row.least), "");
  EXPECT_EQ(refusal_of_step(row, row.most), "");
  const std::optional<SettingRange> range = setting_range(row.name);
  ASSERT_TRUE(range);
  EXPECT_EQ(range->least, static_cast<Real>(row.least));
  EXPECT_EQ(range->most, static_cast<Real>(row.most));
}

TEST(Ranges, OfSettingsIncludeTheirEndsOnly) {
  for (const SettingRow<Real>& row : real_settings) {
    SCOPED_TRACE(row.name);
    expect_ends_accepted(row);
    expect_value_refused(row, std::nextafter(row.least, -beyond_all));
    expect_value_refused(row, std::nextafter(row.most, beyond_all));
    expect_value_refused(row, not_a_number);
  }
  for (const SettingRow<int>& row : whole_settings) {
    SCOPED_TRACE(row.name);
    expect_ends_accepted(row);
    expect_value_refused(row, row.least - 1);
    expect_value_refused(row, row.most + 1);
  }
}

TEST(Ranges, BelongToNumbersOnly) {
  for (const char* name : {"sleeping", "solver", "pass_order", "gravit", ""}) {
    EXPECT_FALSE(setting_range(name)) << name;
  }
}

/// A number of a body's definition, with its range and the words that name it.
struct BodyRow {
  const char* words;
  Real least;
  Real most;
  void (*set)(BodyDef&, Real);
};

constexpr BodyRow body_numbers[] = {
    {"friction", 0, 1e6F, [](BodyDef& def, Real x) { def.friction = x; }},
    {"restitution", 0, 1, [](BodyDef& def, Real x) { def.restitution = x; }},
    {"velocities", -1e18F, 1e18F, [](BodyDef& def, Real x) { def.linear_velocity.x() = x; }},
    {"velocities", -1e18F, 1e18F, [](BodyDef& def, Real x) { def.linear_velocity.z() = x; }},
    {"velocities", -1e18F, 1e18F, [](BodyDef& def, Real x) { def.angular_velocity.y() = x; }},
    {"velocities", -1e18F, 1e18F, [](BodyDef& def, Real x) { def.angular_velocity.z() = x; }},
};

/// The message with which a world refuses a cube of 1 kg; empty if it does not.
template <class Change>
std::string refusal_of_a_cube(const Change& change) {
  World world;
  BodyDef def = body_at(unit_box(), Vec3::Zero());
  def.mass = Real(1);  // with which energies and squares are finite at any speed
  change(def);
  try {
    world.add_body(def);
    return {};
  } catch (const std::invalid_argument& refused) {
    EXPECT_EQ(world.body_count(), 0);
    return refused.what();
  }
}

TEST(Ranges, OfBodiesIncludeTheirEndsOnly) {
  for (const BodyRow& row : body_numbers) {
    SCOPED_TRACE(row.words);
    const auto refusal_of = [&](Real value) {
      return refusal_of_a_cube([&](BodyDef& def) { row.set(def, value); });
    };
    EXPECT_EQ(refusal_of(row.least), "");
    EXPECT_EQ(refusal_of(row.most), "");
    for (const Real outside : {std::nextafter(row.least, -beyond_all),
                               std::nextafter(row.most, beyond_all), not_a_number}) {
      EXPECT_NE(refusal_of(outside).find(row.words), std::string::npos)
          << outside << ": " << refusal_of(outside);
    }
  }
}

TEST(Ranges, OfAMassEndsAtItsLargestNumber) {
  const auto refusal_of = [](Real mass) {
    return refusal_of_a_cube([&](BodyDef& def) { def.mass = mass; });
  };
  EXPECT_EQ(refusal_of(1e15F), "");
  for (const Real mass : {std::nextafter(1e15F, beyond_all), Real(0), not_a_number}) {
    EXPECT_NE(refusal_of(mass).find("mass"), std::string::npos) << mass;
  }
  // The volume is 1 m³, so the density is the mass.
  const auto refusal_of_density = [](Real density) {
    return refusal_of_a_cube([&](BodyDef& def) {
      def.mass.reset();
      def.density = density;
    });
  };
  EXPECT_EQ(refusal_of_density(1e15F), "");
  EXPECT_NE(refusal_of_density(std::nextafter(1e15F, beyond_all)).find("mass"), std::string::npos);
  EXPECT_NE(refusal_of_density(0).find("density"), std::string::npos);
}

}  // namespace
}  // namespace cs550
