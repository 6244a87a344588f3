// SPDX-License-Identifier: MIT
// Inputs that the brains of a species met.
#pragma once

#include <cstddef>
#include <span>
#include <tools/reading/run_manifest.hpp>
#include <vector>

namespace trophic::analysis {

/// Inputs of a brain.
using Inputs = std::vector<double>;

/// For each species of the food web up to `most` different inputs that brains of the species had in these runs, drawn at random
/// and always alike. Throws std::invalid_argument, a sentence that names the file, if a run has no senses.csv, or if it is cut or
/// was changed since the run.
[[nodiscard]] std::vector<std::vector<Inputs>> met_inputs(std::span<const RunManifest> runs, std::size_t most);

}  // namespace trophic::analysis
