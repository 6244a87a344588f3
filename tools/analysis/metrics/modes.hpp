// SPDX-License-Identifier: MIT
// Change, novelty, ecology and complexity of what persists (MODES).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <tools/reading/lineages.hpp>
#include <tools/reading/signatures.hpp>
#include <vector>

namespace trophic::analysis {

/// The measures of one window [dolson2019]. The filter keeps the individuals that were alive at the window's start and are the
/// most recent ancestors, at that time, of those alive at its end.
struct Modes {
  double time_s = 0.0;               ///< end of the window
  std::optional<double> change;      ///< types that persist and did not in the window before; none in the first
  std::optional<double> novelty;     ///< types that persist for the first time; none in the first
  std::optional<double> ecology;     ///< entropy of the types of the individuals kept, bits; none if none is kept
  std::optional<double> complexity;  ///< the greatest among the individuals kept; none if none is kept
};

/// The individuals kept, by place, ascending.
[[nodiscard]] std::vector<std::size_t> persistent(const Forest& forest, Species species, double start_s, double end_s);

/// The windows between successive `times_s`. `types`: of each individual. `complexity`: of an individual.
[[nodiscard]] std::vector<Modes> modes_of(const Forest& forest, Species species, std::span<const Type> types,
                                          std::span<const double> times_s,
                                          const std::function<double(std::size_t place)>& complexity);

}  // namespace trophic::analysis
