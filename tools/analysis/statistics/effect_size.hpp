// SPDX-License-Identifier: MIT
// The size of a difference relative to the spread between runs.
#pragma once

#include <optional>
#include <span>

namespace trophic::analysis {

/// Factor by which the standardised difference of two samples is unbiased [hedges1981]; about 1 - 3 / (4 freedom - 1).
/// `freedom` > 1: degrees of freedom of the standard deviation that divides it.
[[nodiscard]] double hedges_correction(double freedom);

/// Hedges' g [hedges1981]: mean(b) - mean(a) over the pooled spread between runs of both sets, corrected for the number of runs.
/// Sets that are compared run by run are taken as if they were independent, so that paired and unpaired sweeps have the same
/// measure: it says how far apart runs are, not how sure the difference is. Empty with fewer than two runs in a set, or without
/// any spread.
[[nodiscard]] std::optional<double> hedges_g(std::span<const double> a, std::span<const double> b);

}  // namespace trophic::analysis
