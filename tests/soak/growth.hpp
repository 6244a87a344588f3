// SPDX-License-Identifier: MIT
// Tests whether a quantity that is measured all along a run grows: its second half against its first.
#pragma once

#include <cstddef>
#include <span>
#include <tools/analysis/statistics/equivalence.hpp>
#include <tools/analysis/statistics/interval.hpp>
#include <vector>

namespace trophic::test {

/// By how much a number may differ between the halves of a run to count as the same, as a share of the first half's mean.
inline constexpr double same_within = 0.1;

/// The first tenth of the measurements is left out, as a run has to settle, and so are as many of its first as do not fill twenty
/// parts alike. The means of ten parts of each half are then compared by two one-sided tests. Parts must be long
/// enough to be independent of each other. Unknown for fewer than 22 measurements.
[[nodiscard]] inline analysis::EquivalenceTest growth_of(std::span<const double> measured) {
  constexpr std::size_t parts_of_half = 10;
  const std::size_t part = (measured.size() - measured.size() / 10) / (2 * parts_of_half);
  if (part == 0) return {};
  const std::span<const double> settled = measured.last(2 * parts_of_half * part);
  std::vector<double> means;
  for (std::size_t i = 0; i < 2 * parts_of_half; ++i) means.push_back(*analysis::mean_of(settled.subspan(i * part, part)));
  const std::span<const double> parts{means};
  const std::span<const double> early = parts.first(parts_of_half);
  const double margin = same_within * *analysis::mean_of(early);
  if (!(margin > 0.0)) return {};
  return analysis::test_equivalence(early, parts.last(parts_of_half), margin);
}

}  // namespace trophic::test
