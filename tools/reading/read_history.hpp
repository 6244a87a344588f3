// SPDX-License-Identifier: MIT
// Reads what happened in a run, for its neutral null.
#pragma once

#include <filesystem>
#include <trophic/ecology/history.hpp>

namespace trophic::replicates {

/// The events of the run in a folder. Throws std::runtime_error for a run that is not complete, std::invalid_argument for a
/// table that was changed after it.
[[nodiscard]] SharedHistory read_history(const std::filesystem::path& folder);

}  // namespace trophic::replicates
