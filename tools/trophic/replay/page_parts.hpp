// SPDX-License-Identifier: MIT
// The runs of an analysis as files from which its page makes their replays.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <trophic/support/json.hpp>
#include <vector>

namespace trophic::command::replay {

/// Writes into a folder the viewer's page and, as parts of it, the first `most` runs of each set, whose folders are of runs or of
/// replicates. Returns {"viewer": file, "runs": [{"run": folder, "part": file}, ...]}, null if none is wanted. Remarks begin with
/// `who`. By default there are two of each set, and a run that cannot be shown is a remark; otherwise it throws
/// std::invalid_argument.
[[nodiscard]] Json write_parts(const std::filesystem::path& folder, std::span<const std::vector<std::filesystem::path>> sets,
                               std::optional<std::uint64_t> most, const std::string& who);

}  // namespace trophic::command::replay
