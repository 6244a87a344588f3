// SPDX-License-Identifier: MIT
// Are two sets of runs the same for practical purposes? Two one-sided tests against a stated margin.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <tools/analysis/statistics/interval.hpp>

namespace trophic::analysis {

/// `equivalent`: the difference is smaller than the margin. `different`: it is larger than zero, and not shown to be smaller than
/// the margin. `inconclusive`: too scattered runs for either. `unknown`: fewer than `min_runs_for_test` values in a set.
enum class Equivalence { unknown, equivalent, different, inconclusive };
[[nodiscard]] constexpr std::array<std::string_view, 4> enum_names(Equivalence) {
  return {"unknown", "equivalent", "different", "inconclusive"};
}

struct EquivalenceTest {
  std::optional<double> difference;
  std::optional<Interval> interval;  ///< of the difference, at 1 - 2 alpha
  double margin = 0.0;
  Equivalence conclusion = Equivalence::unknown;
};

/// Two one-sided tests [schuirmann1987], each at level `alpha`: equivalent iff the interval of the difference at 1 - 2 alpha
/// lies within +-margin; different iff it does not and the interval at 1 - alpha leaves out zero. Intervals as interval_of.
/// Throws std::invalid_argument unless margin > 0 and alpha lies between 0 and 0.5.
[[nodiscard]] EquivalenceTest test_equivalence(const std::optional<Contrast>& difference, double margin, double alpha = 0.05);

/// Tests mean(b) - mean(a).
[[nodiscard]] EquivalenceTest test_equivalence(std::span<const double> a, std::span<const double> b, double margin,
                                               double alpha = 0.05);

}  // namespace trophic::analysis
