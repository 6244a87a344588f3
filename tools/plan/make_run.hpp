// SPDX-License-Identifier: MIT
// Makes one run of a plan; other programs may make the others.
#pragma once

#include <filesystem>
#include <functional>
#include <tools/plan/plan_file.hpp>
#include <vector>

namespace trophic::plan {

/// State of a planned run, as its folder has it.
enum class Stage { missing, running, interrupted, failed, complete };

/// Looks at a run without changing anything. `plan`: the folder of the plan. A run is running while a program holds its lock.
/// `verifies`: one whose files are damaged is not complete, but failed.
[[nodiscard]] Stage stage_of(const std::filesystem::path& plan, const PlannedRun& run, bool verifies = true);

/// Whether a run's folder holds all of the run that was planned, not of another one.
[[nodiscard]] bool is_complete(const std::filesystem::path& plan, const PlannedRun& run);

/// Makes a run unless it is complete. `work` begins it in its folder or resumes it there from its last checkpoint. The lock of
/// the file "RUN.lock" admits one program at a time; the system releases it when a program dies. Throws std::runtime_error if
/// another program makes the run or a signal ends it, std::invalid_argument if there is a link in its place, and what `work`
/// throws. Files that do not fit their checkpoint are set aside: the next call begins anew. `verifies`: a complete run whose
/// files are damaged is not complete.
void make_run(const std::filesystem::path& plan, const PlannedRun& run,
              const std::function<void(const std::filesystem::path& folder)>& work, bool verifies = true);

/// Throws std::invalid_argument if another build of the program made a part of the complete runs of a plan that has more to do:
/// a mixture of programs must be asked for.
void check_builds(const std::filesystem::path& plan, const std::vector<PlannedRun>& runs);

}  // namespace trophic::plan
