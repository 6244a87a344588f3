// SPDX-License-Identifier: MIT
// One run of a sweep, on which other programs may work, too.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <tools/sweep/plan_file.hpp>
#include <vector>

namespace trophic::sweep {

/// State of a run of a plan after an attempt at it.
enum class Ended {
  was_complete,  ///< before
  complete,
  elsewhere,  ///< another program works on it
  stopped,    ///< by a signal; the next attempt resumes it
  failed,     ///< the next attempt resumes from the last checkpoint
};

struct Result {
  Ended ended = Ended::elsewhere;
  std::string text = {};  ///< of a failure: its error; elsewhere: the program that works on it
};

/// The folder in a sweep's that holds claims while there is work.
inline constexpr const char* claims_name = "claims";

/// Whether a run's folder holds all of the run that was planned, not of another one.
[[nodiscard]] bool is_complete(const std::filesystem::path& sweep, const PlannedRun& run);

/// Claims a run and has `work` do it in a folder of its own, "RUN.attempt-K", which becomes the run's folder when it is complete;
/// older attempts are then removed. It begins at the last checkpoint of an older attempt, whose files it copies: so it does not
/// matter whether that attempt's program still lives. `work` is given the folder and begins or resumes the run in it; what it
/// throws is a failure, and no exception of this function. An older attempt whose files are not what it wrote is set aside, and
/// that is a failure, too: the next attempt begins without it. So are links in the way, and another run in the run's folder.
[[nodiscard]] Result attempt(const std::filesystem::path& sweep, const PlannedRun& run, double lease_s,
                             const std::function<void(const std::filesystem::path& folder)>& work);

/// Throws std::invalid_argument if another build of the program made a part of the complete runs of a plan that has more to do:
/// a mixture of programs must be asked for.
void check_builds(const std::filesystem::path& sweep, const std::vector<PlannedRun>& plan);

/// Removes the claims, also those of killed programs, if all runs of a plan are complete; else their folder if it is empty,
/// because then no program works there.
void remove_claims(const std::filesystem::path& sweep, const std::vector<PlannedRun>& plan);

}  // namespace trophic::sweep
