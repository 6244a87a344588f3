// SPDX-License-Identifier: MIT
// The folder of a sweep: made at once by the first program, joined by programs with the same plan.
#pragma once

#include <filesystem>
#include <string>
#include <tools/sweep/plan_file.hpp>
#include <utility>
#include <vector>

namespace trophic::sweep {

/// A file of a sweep's folder: its path there, and its text.
using NamedText = std::pair<std::filesystem::path, std::string>;

/// Makes the folder with the plan and these files or, if it exists with the same plan, does nothing: programs on several
/// machines may call it at once. If the plan has all runs of the folder's, to the same ends or later ones, and more, it replaces
/// that. Throws std::invalid_argument for a folder with another plan, naming the first run that differs, and for one that is not
/// a sweep's; std::runtime_error if the system refuses.
void make_or_join(const std::filesystem::path& folder, const std::vector<PlannedRun>& plan, const std::vector<NamedText>& files);

}  // namespace trophic::sweep
