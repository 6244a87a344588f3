// SPDX-License-Identifier: MIT
// A run in a folder, from its start or from the point of interruption.
#pragma once

#include <filesystem>
#include <trophic/ecology/simulation.hpp>
#include <trophic/io/growing_file.hpp>
#include <trophic/run/checkpoint/checkpoint_file.hpp>
#include <trophic/run/checkpoint/checkpoint_writer.hpp>
#include <trophic/run/checkpoint/schedule.hpp>

namespace trophic::checkpoint {

/// The state of a run that is to be made in a folder.
struct RunState {
  bool complete = false;  ///< nothing remains to be done
  std::optional<Checkpoint>
      from;             ///< the checkpoint to resume from; if empty, the run starts in a folder that does not exist yet
  std::string remark;   ///< a sentence about the folder's contents; empty if none is needed
  bool begins = false;  ///< whether `from` is a moment of another run, of which the folder is a copy (rewind.hpp)

  [[nodiscard]] Opening opening() const { return from ? Opening::resumed : Opening::created; }
};

/// The "status" in a run's manifest; "missing" without a folder, "unreadable" with a folder but without a complete manifest. Like
/// the functions below, throws UnreadableFile if the system cannot read a file in the folder.
[[nodiscard]] std::string status_of(const std::filesystem::path& folder);

/// Compares the files of a run that has ended with the checksums in its manifest, the manifest with its own and with the
/// checkpoint. Returns the first difference, "FILE: ...", empty if there is none. Throws UnreadableFile.
[[nodiscard]] std::string damage_in(const std::filesystem::path& folder);

/// Whether a folder holds all of a run to `until_s` by its manifest.
[[nodiscard]] bool holds_complete(const std::filesystem::path& folder, const std::string& fingerprint, std::uint64_t seed,
                                  double until_s);

/// The codes (trophic/io/program_code.hpp) of the programs that made a run, as its manifest lists them; empty if unknown.
[[nodiscard]] std::vector<std::string> builds_of(const std::filesystem::path& folder);

/// Throws std::invalid_argument naming the folder if a different program took part in the run there.
void check_build(const std::filesystem::path& folder);

/// Moves a folder to "FOLDER.incomplete-K" and returns the new path.
[[nodiscard]] std::filesystem::path rename_incomplete(const std::filesystem::path& folder);

/// Examines the folder of a run that is to be resumed. A folder without a complete checkpoint, or with one from a different
/// version of trophic, is renamed, because nothing can be resumed there; so is a complete run whose files are damaged, if
/// `schedule` verifies. Throws std::invalid_argument if the folder is not of a run, or of one with different rules, parameters or
/// seed, if a different build of the program wrote its checkpoint and `schedule` does not accept that, or if it contains links;
/// std::runtime_error if another program works in it.
[[nodiscard]] RunState run_state_in(const std::filesystem::path& folder, const observe::RunDescription& run,
                                    const Schedule& schedule = {});

/// Runs an ecology to `until_s` with observers, from its present state or from a checkpoint, and keeps checkpoints in the folder.
/// Observers that take part in checkpoints (see Kept) are read from the checkpoint; then those that own files must have been made
/// with `Opening::resumed`. Throws as `restore` and `run_until` do.
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
