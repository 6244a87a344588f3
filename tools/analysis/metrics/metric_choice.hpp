// SPDX-License-Identifier: MIT
// Metrics by name: METRIC, METRIC:SPECIES or METRIC:SPECIES:GROUP.
#pragma once

#include <tools/analysis/metrics/measurement.hpp>

namespace trophic::analysis {

/// Whether a choice names a metric; a part that is not said is any.
[[nodiscard]] bool chooses(std::string_view choice, const MetricName& name);

/// Those of `names` that any of the choices names, all where there is no choice; in their order. Throws std::invalid_argument,
/// with the names of all metrics, for a choice that names none.
[[nodiscard]] std::vector<MetricName> chosen(std::span<const MetricName> names, std::span<const std::string> choices);

}  // namespace trophic::analysis
