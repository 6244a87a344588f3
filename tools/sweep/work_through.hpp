// SPDX-License-Identifier: MIT
// The runs of a plan on the threads of one program; other programs may work on the same plan.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <tools/sweep/attempt.hpp>
#include <tools/sweep/plan_file.hpp>
#include <vector>

namespace trophic::sweep {

/// Every count-th run of a plan, from the index-th on: 1/4, 2/4, 3/4 and 4/4 are all of it.
struct Shard {
  std::size_t index = 1;  ///< from 1
  std::size_t count = 1;
  [[nodiscard]] bool holds(std::size_t run) const { return run % count == index - 1; }
};

/// "2/8". Throws std::invalid_argument for a text that is not a shard.
[[nodiscard]] Shard shard_of(const std::string& text);

/// The numbers of a plan's runs in the order in which they are begun: those with the most work first, so that none of them is
/// begun when all others have ended.
[[nodiscard]] std::vector<std::size_t> longest_first(const std::vector<PlannedRun>& plan, const Shard& shard = {});

/// State of a sweep after some work on it.
struct Tally {
  std::size_t kept = 0;                 ///< complete at the start
  std::size_t complete = 0;             ///< completed meanwhile, by this program or another
  std::vector<std::string> unfinished;  ///< a sentence for each that failed, was stopped or was not begun
};

/// Counts how the last attempts at the runs of a shard ended; `results` by the plan's numbers.
[[nodiscard]] Tally tally_of(const std::vector<PlannedRun>& plan, const Shard& shard, const std::vector<Result>& results);

/// The result of a run before the first attempt.
inline constexpr const char* not_begun = "not begun";

/// Makes attempts at the runs of a shard, `jobs` at a time, until each is complete or has failed here; waits for those that other
/// programs work on and takes over those whose claims go stale. `go_on` is asked before each attempt and while waiting.
[[nodiscard]] Tally work_through(const std::vector<PlannedRun>& plan, const Shard& shard, std::size_t jobs,
                                 const std::function<Result(const PlannedRun&)>& attempt,
                                 const std::function<bool()>& keep_running);

}  // namespace trophic::sweep
