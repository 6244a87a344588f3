// SPDX-License-Identifier: MIT
// How many runs would show a difference, and how large a difference the runs at hand would show.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <tools/analysis/statistics/interval.hpp>
#include <tools/analysis/statistics/student_t.hpp>
#include <trophic/params/params.hpp>

namespace trophic::analysis {

/// The share of studies that are to find what is there.
inline constexpr double usual_power = 0.8;

/// More runs than anybody makes: a difference that needs more is called undetectable.
inline constexpr std::size_t most_runs = 1'000'000;

/// How scattered a comparison is, run by run. With n runs in each set, or n pairs, its squared error is `variance` / n, of
/// `freedom` (n - 1) degrees of freedom.
struct Scatter {
  double variance = 0.0;
  double freedom = 1.0;
};

/// Of the mean of these values, one a pair; none of fewer than two.
[[nodiscard]] inline std::optional<Scatter> scatter_of(std::span<const double> values) {
  if (values.size() < 2) return std::nullopt;
  return Scatter{std::pow(*deviation_of(values), 2.0), 1.0};
}

/// Of the difference between the means of independent sets, to be repeated with equally many runs in both [welch1947]; none of
/// fewer than two in a set. Sets without any spread have the freedom of one.
[[nodiscard]] inline std::optional<Scatter> scatter_of(std::span<const double> a, std::span<const double> b) {
  const auto of_a = scatter_of(a);
  const auto of_b = scatter_of(b);
  if (!of_a || !of_b) return std::nullopt;
  const double sum = of_a->variance + of_b->variance;
  const double squares = of_a->variance * of_a->variance + of_b->variance * of_b->variance;
  return Scatter{sum, squares > 0.0 ? sum * sum / squares : 1.0};
}

/// How often a two-sided t test at `level` finds a difference of this many errors: by the noncentral t distribution
/// [cohen1988]. `freedom` > 0, 0 < level < 1.
[[nodiscard]] double power_of_t(double errors, double freedom, double level);

/// How many errors a difference must have for a two-sided t test at `level` to find it with `power`. Bounds as power_of_t.
[[nodiscard]] double errors_for_power(double freedom, double level, double power = usual_power);

/// The smallest difference that a comparison with this error and freedom would find with `power` at `level`, two-sided.
[[nodiscard]] inline double detectable_difference(const Contrast& of, double level, double power = usual_power) {
  return of.error == 0.0 ? 0.0 : of.error * errors_for_power(of.freedom, level, power);
}

/// The fewest runs in each set (or pairs), `runs_for_verdict` at least, with which a difference is found with `power` at `level`,
/// two-sided, if it and the scatter are what they are said to be. None for no difference, and where `most_runs` are too few.
/// Asked of a difference that was observed this says no more than its p value does [hoenig2001]: it is for the next study. Throws
/// std::invalid_argument unless level and power lie between 0 and 1.
[[nodiscard]] inline std::optional<std::size_t> runs_for_power(double difference, const Scatter& scatter, double level,
                                                               double power = usual_power) {
  const auto check = [](const char* name, double value) {
    if (value > 0.0 && value < 1.0) return;
    throw std::invalid_argument{std::string{name} + " = " + number_text(value) + ": must be > 0 and < 1"};
  };
  check("level", level);
  check("power", power);
  if (difference == 0.0) return std::nullopt;
  if (is_rounding(std::sqrt(scatter.variance), difference)) return runs_for_verdict;
  const double spreads = std::abs(difference) / std::sqrt(scatter.variance);
  const auto suffices = [&](std::size_t runs) {
    const auto count = static_cast<double>(runs);
    return power_of_t(spreads * std::sqrt(count), scatter.freedom * (count - 1.0), level) >= power;
  };
  // The normal distribution asks for fewer runs than t does: from there upwards in growing steps, then back by halving.
  constexpr double as_good_as_normal = 1e9;
  const double wanted = student_t_quantile(1.0 - level / 2.0, as_good_as_normal) + student_t_quantile(power, as_good_as_normal);
  const double fewest = std::pow(std::max(wanted, 0.0) / spreads, 2.0);
  if (fewest > static_cast<double>(most_runs)) return std::nullopt;
  std::size_t enough = std::max(runs_for_verdict, static_cast<std::size_t>(fewest));
  std::size_t few = enough - 1;
  for (std::size_t step = 1; !suffices(enough); step *= 2) {
    few = enough;
    enough += step;
    if (enough > most_runs) return std::nullopt;
  }
  while (enough - few > 1) {
    const std::size_t middle = few + (enough - few) / 2;
    (suffices(middle) ? enough : few) = middle;
  }
  return enough;
}

}  // namespace trophic::analysis
