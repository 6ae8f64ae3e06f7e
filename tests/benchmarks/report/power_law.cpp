#include "benchmarks/report/power_law.hpp"

#include <cmath>
#include <stdexcept>

namespace cs550::bench {

PowerLaw fit_power_law(std::span<const Cost> costs) {
  double mean_x = 0, mean_y = 0;
  for (const Cost& cost : costs) {
    if (!(cost.n > 0 && cost.seconds > 0))
      throw std::invalid_argument("a power law needs positive sizes and costs");
    mean_x += std::log(cost.n) / static_cast<double>(costs.size());
    mean_y += std::log(cost.seconds) / static_cast<double>(costs.size());
  }
  double covariance = 0, variance = 0;
  for (const Cost& cost : costs) {
    const double x = std::log(cost.n) - mean_x;
    covariance += x * (std::log(cost.seconds) - mean_y);
    variance += x * x;
  }
  if (variance == 0) throw std::invalid_argument("a power law needs costs of at least two sizes");
  const double exponent = covariance / variance;
  return {std::exp(mean_y - exponent * mean_x), exponent};
}

}  // namespace cs550::bench
