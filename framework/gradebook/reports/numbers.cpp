#include "gradebook/reports/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace cs550::gradebook {

double mean_of(const Numbers& x) {
  return x.empty() ? 0 : std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

double deviation_of(const Numbers& x) {
  const double mean = mean_of(x);
  double sum = 0;
  for (const double value : x) sum += (value - mean) * (value - mean);
  return x.empty() ? 0 : std::sqrt(sum / static_cast<double>(x.size()));
}

double median_of(Numbers x) {
  if (x.empty()) return 0;
  std::sort(x.begin(), x.end());
  const std::size_t half = x.size() / 2;
  return x.size() % 2 == 1 ? x[half] : (x[half - 1] + x[half]) / 2;
}

std::optional<double> correlation(const Numbers& x, const Numbers& y) {
  const double scale = deviation_of(x) * deviation_of(y);
  if (scale < 1e-12) return std::nullopt;
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += (x[i] - mean_of(x)) * (y[i] - mean_of(y));
  return sum / static_cast<double>(x.size()) / scale;
}

}  // namespace cs550::gradebook
