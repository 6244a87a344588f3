// SPDX-License-Identifier: MIT
// Definitions of estimate.hpp.
#include <tools/analysis/statistics/estimate.hpp>

namespace trophic::analysis {

Estimate estimate(std::span<const double> values) {
  return {values.size(), mean_of(values), deviation_of(values), interval_of_mean(values)};
}

}  // namespace trophic::analysis
