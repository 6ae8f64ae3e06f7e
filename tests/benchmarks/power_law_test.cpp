// Exponents are fitted to costs against sizes.

#include "benchmarks/report/power_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "benchmarks/report/report.hpp"

namespace cs550::bench {
namespace {

std::vector<Cost> exact_costs(double factor, double exponent) {
  std::vector<Cost> costs;
  for (const double n : {8.0, 100.0, 8192.0, 3.0})
    costs.push_back({n, factor * std::pow(n, exponent)});
  return costs;
}

TEST(PowerLaw, IsFoundExactly) {
  for (const double exponent : {0.0, 0.5, 1.0, 2.0, -1.5}) {
    const PowerLaw law = fit_power_law(exact_costs(3e-9, exponent));
    EXPECT_NEAR(law.exponent, exponent, 1e-12);
    EXPECT_NEAR(law.factor, 3e-9, 1e-18);
  }
}

TEST(PowerLaw, IsTheLeastSquaresOfLogarithms) {
  // Logarithms 0, 1, 2 of n with 0, 3, 0 of the cost: the best line is flat, at their mean.
  const double e = std::exp(1);
  const std::vector<Cost> costs = {{1, 1}, {e, e * e * e}, {e * e, 1}};
  const PowerLaw law = fit_power_law(costs);
  EXPECT_NEAR(law.exponent, 0, 1e-12);
  EXPECT_NEAR(law.factor, e, 1e-12);
}

TEST(PowerLaw, NeedsTwoSizesAndPositiveCosts) {
  EXPECT_THROW(fit_power_law({}), std::invalid_argument);
  EXPECT_THROW(fit_power_law(std::vector<Cost>{{8, 1}, {8, 2}}), std::invalid_argument);
  EXPECT_THROW(fit_power_law(std::vector<Cost>{{8, 1}, {16, 0}}), std::invalid_argument);
}

TEST(PowerLaw, OfAFamilyIsFittedByItsName) {
  Report report;
  for (const Cost& cost : exact_costs(1e-9, 1))
    report.stages.push_back({"support/all/n", cost.n, cost.seconds});
  for (const Cost& cost : exact_costs(1e-9, 0.5))
    report.stages.push_back({"support/climb/n", cost.n, cost.seconds});
  report.stages.push_back({"gauss_map/arcs", 0, 1e-9});
  report.scaling.push_back({"cubes", exact_costs(1e-6, 1.1)});
  const std::vector<FittedFamily> families = fitted_families(report);
  ASSERT_EQ(families.size(), 3U);
  EXPECT_EQ(families[0].name, "support/all");
  EXPECT_NEAR(families[0].law.exponent, 1, 1e-12);
  EXPECT_NEAR(families[1].law.exponent, 0.5, 1e-12);
  EXPECT_EQ(families[1].smallest, 3);
  EXPECT_EQ(families[1].largest, 8192);
  EXPECT_EQ(families[2].name, "step/cubes");
  EXPECT_NEAR(families[2].law.exponent, 1.1, 1e-12);
}

}  // namespace
}  // namespace cs550::bench
