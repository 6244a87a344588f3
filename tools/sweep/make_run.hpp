// SPDX-License-Identifier: MIT
// Makes one run of a sweep; other programs may make the others.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <tools/sweep/plan_file.hpp>
#include <vector>

namespace trophic::sweep {

/// State of a planned run, as its folders have it.
enum class Stage { missing, running, interrupted, failed, complete };

/// Looks at a run without changing anything. A run is running while a program holds its lock. `verifies`: one whose files are
/// damaged is not complete, but failed.
[[nodiscard]] Stage stage_of(const std::filesystem::path& sweep, const PlannedRun& run, bool verifies = true);

/// Whether a run's folder holds all of the run that was planned, not of another one.
[[nodiscard]] bool is_complete(const std::filesystem::path& sweep, const PlannedRun& run);

/// Makes a run unless it is complete. `work` begins it in the folder "RUN.making" or resumes it there from its last checkpoint;
/// when it is complete that folder gets the run's name. The lock of the file "RUN.lock" admits one program at a time; the system
/// releases it when a program dies. Throws std::runtime_error if another program makes the run or a signal ends it,
/// std::invalid_argument if a link or another run is in its place, and what `work` throws. A folder whose files are not what was
/// written there is set aside, and the next call begins anew. If `verifies`, a complete run whose files are damaged is set aside
/// and made anew. Returns a sentence about such a run, else an empty text.
std::string make_run(const std::filesystem::path& sweep, const PlannedRun& run,
                     const std::function<void(const std::filesystem::path& folder)>& work, bool verifies = true);

/// Throws std::invalid_argument if another build of the program made a part of the complete runs of a plan that has more to do:
/// a mixture of programs must be asked for.
void check_builds(const std::filesystem::path& sweep, const std::vector<PlannedRun>& plan);

}  // namespace trophic::sweep
