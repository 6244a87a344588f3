// SPDX-License-Identifier: MIT
// All metrics of one run.
#pragma once

#include <cstdint>
#include <tools/analysis/metrics/measurement.hpp>
#include <tools/reading/read_run.hpp>

namespace trophic::analysis {

/// Hunters that the released rules leave when they starve and rescue at their floor: the authors' runs have 8 for 30 % of the
/// time.
inline constexpr std::size_t crowd_at_floor = 8;

/// Half a sentence about the metrics that a run loses if agents.csv has only the ticks that are multiples of `every`; empty if it
/// loses none. All other metrics are means over ticks or come from events.
[[nodiscard]] std::string lost_to_thinning(std::int64_t every);

/// All metrics of a run, for any number of species, in an order that depends only on the food web. A metric whose table is
/// missing, has no row or lacks the ticks for it is there without a value.
[[nodiscard]] RunMetrics measure_run(const RunData& run);

}  // namespace trophic::analysis
