// SPDX-License-Identifier: MIT
// The runs in a folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace trophic::analysis {

/// The folders of the runs that a path stands for: the path itself, or the replicates that its replicates.json lists. A listed
/// folder that is missing gets a remark. Throws std::invalid_argument for a path that is not a folder or a broken list.
[[nodiscard]] std::vector<std::filesystem::path> run_folders(const std::filesystem::path& path,
                                                             std::vector<std::string>& remarks);

}  // namespace trophic::analysis
