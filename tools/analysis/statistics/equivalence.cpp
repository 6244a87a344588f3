// SPDX-License-Identifier: MIT
// Definitions of equivalence.hpp.
#include <tools/analysis/statistics/equivalence.hpp>

#include <stdexcept>
#include <trophic/params/params.hpp>

namespace trophic::analysis {

EquivalenceTest test_equivalence(const std::optional<Contrast>& difference, double margin, double alpha) {
  if (!(margin > 0.0)) throw std::invalid_argument{"margin = " + number_text(margin) + ": must be > 0"};
  if (!(alpha > 0.0 && alpha < 0.5)) throw std::invalid_argument{"alpha = " + number_text(alpha) + ": must be > 0 and < 0.5"};
  EquivalenceTest test;
  test.margin = margin;
  if (!difference) return test;
  test.difference = difference->value;
  test.interval = interval_of(difference, 1.0 - 2.0 * alpha);
  const Interval wide = *interval_of(difference, 1.0 - alpha);
  const bool within = test.interval->lower > -margin && test.interval->upper < margin;
  const bool apart = wide.lower > 0.0 || wide.upper < 0.0;
  test.conclusion = within ? Equivalence::equivalent : apart ? Equivalence::different : Equivalence::inconclusive;
  return test;
}

EquivalenceTest test_equivalence(std::span<const double> a, std::span<const double> b, double margin, double alpha) {
  EquivalenceTest test = test_equivalence(contrast({{-1.0, a}, {1.0, b}}), margin, alpha);
  if (!a.empty() && !b.empty()) test.difference = *mean_of(b) - *mean_of(a);
  return test;
}

}  // namespace trophic::analysis
