// SPDX-License-Identifier: MIT
// One run of a sweep, on which other programs may work, too.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <trophic/run/sweep/plan_file.hpp>
#include <trophic/support/linkage.hpp>
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

/// Whether a run's folder holds all of it.
[[nodiscard]] bool is_complete(const std::filesystem::path& sweep, const PlannedRun& run);

/// Claims a run and has `work` do it in a folder of its own, "RUN.attempt-K", which becomes the run's folder when it is complete;
/// older attempts are then removed. It begins at the last checkpoint of an older attempt, whose files it copies: so it does not
/// matter whether that attempt's program still lives. `work` takes the folder and runs or resumes in it; its exception is a
/// failure, not an exception of this function.
[[nodiscard]] Result attempt(const std::filesystem::path& sweep, const PlannedRun& run, double lease_s,
                             const std::function<void(const std::filesystem::path& folder)>& work);

/// Removes the claims if all runs of a plan are complete, also those of killed programs; else their folder if it
/// is empty, as no program works there.
void remove_claims(const std::filesystem::path& sweep, const std::vector<PlannedRun>& plan);

}  // namespace trophic::sweep

#if TROPHIC_HEADER_ONLY
#include <trophic/run/sweep/attempt.ipp>
#endif
