// SPDX-License-Identifier: MIT
// Rewinding the tape: a new run that begins at a moment of an old one, with another seed or other rules.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <trophic/ecology/simulation.hpp>
#include <trophic/io/manifest.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/run/checkpoint/checkpoint_file.hpp>
#include <trophic/run/checkpoint/checkpoint_writer.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/support/folder_lock.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic::checkpoint {

/// A moment of a run, at which others begin.
struct Moment {
  std::filesystem::path run;  ///< its folder
  std::string fingerprint;    ///< the run's
  std::string code = {};      ///< of the program that began it; empty if unknown
  std::uint64_t seed = 0;     ///< the run's
  double at_s = 0.0;          ///< seconds of its clock
};

/// A run as it was at a moment, its tables and its checkpoint, in a folder that is not the run's own.
struct Snapshot {
  Moment moment;
  std::filesystem::path folder;
};

/// What manifests and lists of runs say of the moment at which they begin.
[[nodiscard]] io::Provenance provenance_of(const Moment& moment);

/// When a run's last checkpoint was taken, seconds of its clock; none without one.
[[nodiscard]] std::optional<double> last_moment_s(const std::filesystem::path& run);

/// Where to make the past of what begins at a moment and goes to `out`: in a folder beside it, whose name says which moment of
/// which run.
[[nodiscard]] std::filesystem::path snapshot_folder(const std::filesystem::path& out, const Moment& moment);

/// The folder around a past, this program's alone; it goes where nothing is left in it.
class SnapshotFolder {
 public:
  /// Makes it where it is not. Throws std::runtime_error where another program has it.
  explicit SnapshotFolder(const Snapshot& snapshot);
  SnapshotFolder(const SnapshotFolder&) = delete;
  SnapshotFolder& operator=(const SnapshotFolder&) = delete;
  ~SnapshotFolder();

  /// Whether there is one, of this program or another.
  [[nodiscard]] static bool exists(const Snapshot& snapshot);

  /// Removes what is in it.
  void clear();

 private:
  std::filesystem::path folder_;
  FolderLock lock_;
};

/// Whether a run to `until_s` that begins at a moment needs the past of it: not one that is complete in its folder or can go on
/// there.
[[nodiscard]] bool needs_snapshot(const std::filesystem::path& folder, double until_s);

/// Makes `folder` a copy of a run's folder as far as its latest checkpoint of this version at or before `at_s`, which another run
/// can go on from. Does nothing if there is none: then that other run begins at its beginning. Throws std::invalid_argument if
/// `folder` exists, std::runtime_error if a file cannot be copied.
void copy_until(const std::filesystem::path& run, double at_s, const std::filesystem::path& folder);

/// Where a run that begins at a moment stands in its folder: there, in a copy that is made where there is nothing to go on from,
/// or further on. Without a past as the other `run_state_in`. Throws as that one and as `copy_until`, and std::invalid_argument
/// where the run in the folder began elsewhere.
[[nodiscard]] RunState run_state_in(const std::filesystem::path& folder, const observe::RunDescription& run,
                                    const std::optional<Snapshot>& snapshot, OtherBuild other_build = OtherBuild::refused);

/// Lets a run begin that stands at a moment of another one. Throws as `restore_any`.
void begin_at(RunState& run_state, const Moment& moment, Simulation& ecology, io::Manifest& manifest, const Parts& parts);

/// Throws std::invalid_argument naming the first number in which two runs differ that a run cannot change on its way: all but
/// rules, seed, duration and threads.
void check_may_follow(const observe::RunDescription& origin, const observe::RunDescription& run);

}  // namespace trophic::checkpoint

#if TROPHIC_HEADER_ONLY
#include <trophic/run/checkpoint/rewind.ipp>
#endif
