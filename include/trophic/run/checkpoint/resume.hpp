// SPDX-License-Identifier: MIT
// A run in a folder, from its beginning or from where it was interrupted.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <trophic/ecology/simulation.hpp>
#include <trophic/io/growing_file.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/run/checkpoint/checkpoint_file.hpp>
#include <trophic/run/checkpoint/checkpoint_writer.hpp>
#include <trophic/run/checkpoint/schedule.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic::checkpoint {

/// State of a run that is to be made in a folder.
struct RunState {
  bool complete = false;           ///< nothing is left to do
  std::optional<Checkpoint> from;  ///< to resume from; none: the run begins, in a folder that does not exist
  std::string remark;              ///< a sentence about the folder's contents; empty if none is needed
  bool begins = false;             ///< `from` is a moment of another run, of which the folder is a copy (rewind.hpp)

  [[nodiscard]] Opening opening() const { return from ? Opening::resumed : Opening::created; }
};

/// The "status" in a run's manifest; "missing" without a folder, "unreadable" with a folder but no manifest that can be read.
[[nodiscard]] std::string status_of(const std::filesystem::path& folder);

/// Moves a folder to "FOLDER.incomplete-K" and returns the new path.
[[nodiscard]] std::filesystem::path rename_incomplete(const std::filesystem::path& folder);

/// Examines the folder of a run that is to be resumed. A folder without a readable checkpoint, or with one of another
/// version of trophic, is renamed, as no run can be resumed there. Throws std::invalid_argument if the folder is of a run with
/// other rules, numbers or another seed, std::runtime_error if another program works in it.
[[nodiscard]] RunState run_state_in(const std::filesystem::path& folder, const observe::RunDescription& run);

/// Runs an ecology to `until_s` with observers, from its present state or from a checkpoint, and keeps checkpoints in the folder.
/// Observers that take part in checkpoints (see Kept) are read from it; with one, those that own files must have been made with
/// `Opening::resumed`. Throws as `restore` and `run_until` do.
template <class... Observers>
void run_with_checkpoints(Simulation& ecology, double until_s, const std::filesystem::path& folder, const Schedule& schedule,
                          const std::optional<Checkpoint>& from, Observers&... observers) {
  const Parts parts = parts_of(observers...);
  if (from) restore(*from, ecology, parts);
  CheckpointWriter writer{folder, schedule, parts};
  ecology.run_until(until_s, observers..., writer);
}

}  // namespace trophic::checkpoint

#if TROPHIC_HEADER_ONLY
#include <trophic/run/checkpoint/resume.ipp>
#endif
