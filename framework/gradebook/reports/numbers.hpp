#pragma once
/// @file numbers.hpp
/// Statistics of a list of numbers; 0 for an empty one.

#include <optional>
#include <vector>

namespace cs550::gradebook {

using Numbers = std::vector<double>;

double mean_of(const Numbers& x);
double median_of(Numbers x);
/// The standard deviation of all of them, not of a sample.
double deviation_of(const Numbers& x);
/// Pearson's r of two lists of the same length; nothing if one of them is constant.
std::optional<double> correlation(const Numbers& x, const Numbers& y);

}  // namespace cs550::gradebook
