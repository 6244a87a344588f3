// SPDX-License-Identifier: MIT
// Means over runs, their intervals and tests, by Student's t.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>

namespace trophic::analysis {

/// A set of fewer runs gets its mean and spread, but no interval and no test result.
inline constexpr std::size_t min_runs_for_test = 6;

struct Interval {
  double lower = 0.0;
  double upper = 0.0;
};

/// The ends of an interval, where there is one.
[[nodiscard]] std::optional<double> lower_of(const std::optional<Interval>& interval);
[[nodiscard]] std::optional<double> upper_of(const std::optional<Interval>& interval);

/// The arithmetic mean; empty without values.
[[nodiscard]] std::optional<double> mean_of(std::span<const double> values);

/// The standard deviation between runs, with n - 1; empty if there are fewer than two values.
[[nodiscard]] std::optional<double> deviation_of(std::span<const double> values);

/// A spread that is only the rounding of a value counts as none.
[[nodiscard]] bool is_rounding(double spread, double value);

/// One set of runs in a contrast, with the weight of its mean.
struct Term {
  double weight = 1.0;
  std::span<const double> values;
};

/// A weighted sum of the means of independent sets, with its standard error and the degrees of freedom of that error.
struct Contrast {
  double value = 0.0;
  double error = 0.0;
  double freedom = 0.0;
};

/// For one set Student's t (n - 1 degrees of freedom). For several Welch's approximation [welch1947], which lets every set have
/// its own spread. None if a set has fewer than `min_runs_for_test` values.
[[nodiscard]] std::optional<Contrast> contrast(std::initializer_list<Term> terms);

/// The interval that holds the true value of a contrast with probability `level`; a point where no set has any spread.
///
/// Chosen by simulation: share of 95 % intervals that leave out the true mean, in %, at 6 / 10 / 20 runs. 2000 samples each;
/// 40,000 of t. "Kinematic": medians over eight metrics of 150 runs each of `paper` and `released`, drawn with replacement.
///
///                        Student's t       percentile          BCa                 studentised bootstrap
///   normal               5.0 / 5.2 / 4.9   15.8 / 10.8 / 7.8   14.9 / 10.7 / 8.2   5.1 / 5.3 / 5.2
///   uniform              6.0 / 5.4 / 5.1   13.1 /  9.8 / 7.4   12.9 /  7.7 / 5.5   3.9 / 3.0 / 3.6
///   gamma, skewness 0.5  5.3 / 5.4 / 5.3   13.7 / 10.9 / 7.5   14.2 / 11.7 / 8.2   6.8 / 5.6 / 6.5
///   gamma, skewness 1.0  6.7 / 6.5 / 5.7   14.0 / 10.6 / 7.1   15.3 / 10.8 / 8.8   6.7 / 5.8 / 6.1
///   kinematic            5.3 / 5.4 / 5.7   15.1 / 10.6 / 7.7   14.9 / 10.8 / 8.0   5.8 / 5.8 / 5.6
///
/// So t: no worse than the studentised bootstrap, and without random draws. Of 58 metrics of those runs 48 are within 1.5 points
/// at 6 and 10 runs. Not so: tag symmetry (7.5 to 8.1 at 6 runs), velocity of predators (6.7 to 7.8), and counts that hardly vary
/// but for single odd runs (deaths of predators and hunger in `paper`, 14 to 37), for which no method of so few runs is right.
[[nodiscard]] std::optional<Interval> interval_of(const std::optional<Contrast>& of, double level = 0.95);

/// Two-sided: how often a contrast this far from `from` would come by chance alone. None where nothing varies and nothing
/// differs.
[[nodiscard]] std::optional<double> p_value(const std::optional<Contrast>& of, double from = 0.0);

[[nodiscard]] std::optional<Interval> interval_of_mean(std::span<const double> values, double level = 0.95);

/// The interval of mean(b) - mean(a).
[[nodiscard]] std::optional<Interval> interval_of_difference(std::span<const double> a, std::span<const double> b,
                                                             double level = 0.95);

}  // namespace trophic::analysis
