// libccd's GJK and EPA beside the separating-axis test, on the pairs that are timed.

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <vector>

#include "benchmarks/quality/hull_overlap.hpp"
#include "benchmarks/stages/gjk.hpp"
#include "benchmarks/stages/hull_pairs.hpp"

namespace cs550::bench {
namespace {

PlacedHull placed(const PosedShape& body) {
  BodyMotion motion;
  motion.position = body.pose.position.cast<double>();
  motion.orientation = body.pose.orientation.cast<double>();
  return {*body.shape, motion};
}

/// Errors of the depth of the pairs (m), sorted.
struct DepthErrors {
  std::vector<double> axis;
  std::vector<double> epa;
};

DepthErrors compare_depths(const HullPairs& hulls) {
  DepthErrors errors;
  for (const HullPair& pair : hulls.pairs) {
    const double exact = penetration_depth(placed(pair.a), placed(pair.b));
    const SeparatingAxis axis = find_separating_axis(pair.a, pair.b, {}, HullPairs::margin);
    errors.axis.push_back(-static_cast<double>(axis.separation) - exact);
    errors.epa.push_back(epa_depth(pair.a, pair.b).value() - exact);
  }
  std::sort(errors.axis.begin(), errors.axis.end());
  std::sort(errors.epa.begin(), errors.epa.end());
  return errors;
}

DepthErrors report_depths(int vertices, double least, double most) {
  constexpr double wrong = 1e-3;  // m
  const HullPairs hulls(vertices, static_cast<Real>(-most), static_cast<Real>(-least));
  DepthErrors errors = compare_depths(hulls);
  const auto count = std::count_if(errors.epa.begin(), errors.epa.end(),
                                   [](double error) { return error < -wrong; });
  std::cout << vertices << " vertices, " << least << " to " << most << " m deep: axis "
            << 1e6 * errors.axis.front() << " to " << 1e6 * errors.axis.back() << " um; EPA "
            << 1e6 * errors.epa.front() << " to " << 1e6 * errors.epa.back()
            << " um, more than 1 mm too shallow in " << count << " of " << errors.epa.size()
            << '\n';
  return errors;
}

/// For bodies of radius 1 m: the axis may be one that ties with the best; then rounding.
constexpr double axis_tolerance = static_cast<double>(tie_tolerance) + 1e-5;
/// Both sides in double precision, but the directions of the climb are float.
constexpr double epa_tolerance = 1e-6;

TEST(Gjk, FindsTheDepthOfShallowPairs) {
  for (const int vertices : {8, 32, 128}) {
    const auto [axis, epa] = report_depths(vertices, 0, 0.1);
    EXPECT_GT(axis.front(), -axis_tolerance);
    EXPECT_LT(axis.back(), axis_tolerance);
    EXPECT_GT(epa.front(), -epa_tolerance);
    EXPECT_LT(epa.back(), epa_tolerance);
  }
}

TEST(Gjk, FindsTheDepthOfMostDeepPairs) {
  for (const int vertices : {8, 32, 128}) {
    const auto [axis, epa] = report_depths(vertices, 0.3, 1);
    EXPECT_GT(axis.front(), -axis_tolerance);
    EXPECT_LT(axis.back(), axis_tolerance);
    // The polytope is inside B − A, so its depth is never too large; the library may stop too early.
    EXPECT_LT(epa.back(), epa_tolerance);
    EXPECT_GT(epa[epa.size() / 4], -epa_tolerance);
  }
}

TEST(Gjk, AgreesOnWhetherBodiesOverlap) {
  // Closer than a tenth of a millimetre, rounding of the supports decides.
  const Real band = Real(1e-4);
  for (const HullPair& pair : HullPairs(32, -1, -band).pairs)
    EXPECT_TRUE(gjk_overlap(pair.a, pair.b));
  for (const HullPair& pair : HullPairs(32, band, 1).pairs)
    EXPECT_FALSE(gjk_overlap(pair.a, pair.b));
}

}  // namespace
}  // namespace cs550::bench
