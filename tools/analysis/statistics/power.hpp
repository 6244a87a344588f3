// SPDX-License-Identifier: MIT
// How many runs would show a difference, and how large a difference the runs at hand would show.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <tools/analysis/statistics/interval.hpp>

namespace trophic::analysis {

/// The share of studies that are to find what is there.
inline constexpr double usual_power = 0.8;

/// A difference that needs more runs than this is called undetectable.
inline constexpr std::size_t most_runs = 1'000'000;

/// How scattered a comparison is, run by run. With n runs in each set, or n pairs, its squared error is `variance` / n, of
/// `freedom` (n - 1) degrees of freedom.
struct Scatter {
  double variance = 0.0;
  double freedom = 1.0;
};

/// The scatter of the mean of these values, one a pair; empty if there are fewer than two.
[[nodiscard]] std::optional<Scatter> scatter_of(std::span<const double> values);

/// The scatter of a sum or difference of the means of independent sets, to be repeated with equally many runs in each
/// [welch1947]; empty if a set has fewer than two. Sets without any spread have the freedom of one.
[[nodiscard]] std::optional<Scatter> scatter_of(std::initializer_list<std::span<const double>> sets);
[[nodiscard]] std::optional<Scatter> scatter_of(std::span<const double> a, std::span<const double> b);

/// How often a two-sided t test at `level` finds a difference of this many errors: by the noncentral t distribution
/// [cohen1988]. `freedom` > 0, 0 < level < 1.
[[nodiscard]] double power_of_t(double errors, double freedom, double level);

/// How many errors a difference must have for a two-sided t test at `level` to find it with `power`. Bounds as power_of_t.
[[nodiscard]] double errors_for_power(double freedom, double level, double power = usual_power);

/// The smallest difference that a comparison with this error and freedom would find with `power` at `level`, two-sided.
[[nodiscard]] double detectable_difference(const Contrast& of, double level, double power = usual_power);

/// The fewest runs in each set (or pairs), `min_runs_for_test` at least, with which a difference is found with `power` at
/// `level`, two-sided, if it and the scatter are what they are said to be. None for no difference, and where `most_runs` are too
/// few. Asked of a difference that was observed this says no more than its p value does [hoenig2001]: it is for the next study.
/// Throws std::invalid_argument unless level and power lie between 0 and 1.
[[nodiscard]] std::optional<std::size_t> runs_for_power(double difference, const Scatter& scatter, double level,
                                                        double power = usual_power);

}  // namespace trophic::analysis
