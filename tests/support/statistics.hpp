// SPDX-License-Identifier: MIT
// Moments and counts of samples, to compare a random rule with its formula.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace trophic::test {

struct Moments {
  double mean = 0.0;
  double sd = 0.0;
  double skewness = 0.0;
  double kurtosis = 0.0;  ///< 3 for a normal, 1.8 for a uniform distribution
  double smallest = 0.0;
  double largest = 0.0;
};

[[nodiscard]] inline Moments moments(std::span<const double> sample) {
  const auto size = static_cast<double>(sample.size());
  Moments result;
  for (const double x : sample) result.mean += x / size;
  double second = 0.0;
  double third = 0.0;
  double fourth = 0.0;
  for (const double x : sample) {
    const double d = x - result.mean;
    second += d * d / size;
    third += d * d * d / size;
    fourth += d * d * d * d / size;
  }
  result.sd = std::sqrt(second);
  result.skewness = third / (second * result.sd);
  result.kurtosis = fourth / (second * second);
  result.smallest = *std::ranges::min_element(sample);
  result.largest = *std::ranges::max_element(sample);
  return result;
}

/// Pearson's chi-square of counts that are all expected to be equal; counts.size() - 1 degrees of freedom.
[[nodiscard]] inline double chi_square(std::span<const std::size_t> counts) {
  double total = 0.0;
  for (const std::size_t count : counts) total += static_cast<double>(count);
  const double expected = total / static_cast<double>(counts.size());
  double sum = 0.0;
  for (const std::size_t count : counts) {
    const double d = static_cast<double>(count) - expected;
    sum += d * d / expected;
  }
  return sum;
}

/// Samples sorted into equal classes of [lower, upper).
[[nodiscard]] inline std::vector<std::size_t> histogram(std::span<const double> sample, double lower, double upper,
                                                        std::size_t classes) {
  std::vector<std::size_t> counts(classes, 0);
  for (const double x : sample) {
    const double place = (x - lower) / (upper - lower) * static_cast<double>(classes);
    ++counts.at(static_cast<std::size_t>(place));
  }
  return counts;
}

}  // namespace trophic::test
