// SPDX-License-Identifier: MIT
// Whether the tables next to a recording are of the same run.
#pragma once

#include <filesystem>
#include <tools/recording/read_recording.hpp>
#include <trophic/support/json.hpp>

namespace trophic::command::replay {

/// Throws std::invalid_argument unless events.csv, agents.csv, phylogeny.csv and, where it is there, senses.csv are of the run
/// that was recorded; std::runtime_error for one that cannot be read. A run that was killed has no checksums: then row by row.
void check_own_tables(const std::filesystem::path& folder, const io::RecordingReader& recording, const Json& manifest);

}  // namespace trophic::command::replay
