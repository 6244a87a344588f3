// SPDX-License-Identifier: MIT
// Rewinding the tape: a new run that begins at a moment of an old one, with another seed or other rules.
#pragma once

#include <filesystem>
#include <trophic/ecology/simulation.hpp>
#include <trophic/io/manifest.hpp>
#include <trophic/run/checkpoint/checkpoint_file.hpp>
#include <trophic/run/checkpoint/checkpoint_writer.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/support/folder_lock.hpp>

namespace trophic::checkpoint {

/// A moment of a run, at which others begin.
struct Moment {
  std::filesystem::path run;  ///< its folder
  std::string fingerprint;    ///< the run's
  std::string code = {};      ///< of the program that began it; empty if unknown
  std::uint64_t seed = 0;     ///< the run's
  double at_s = 0.0;          ///< seconds of its clock
};

/// A run up to a moment, its tables and its checkpoint, in a folder that is not the run's own.
struct Snapshot {
  Moment moment;
  std::filesystem::path folder;
};

/// The entry of manifests and lists of runs about the moment at which they begin.
[[nodiscard]] io::Provenance provenance_of(const Moment& moment);

/// Moment of a run's last checkpoint, seconds of its clock; `nullopt` without one.
[[nodiscard]] std::optional<double> last_moment_s(const std::filesystem::path& run);

/// Place for the past of runs that begin at a moment and go to `out`: a folder next to it, whose name contains the run and the
/// moment.
[[nodiscard]] std::filesystem::path snapshot_folder(const std::filesystem::path& out, const Moment& moment);

/// The folder around a past, this program's alone; it is removed when it is empty.
class SnapshotFolder {
 public:
  /// Makes it if it does not exist. Throws std::runtime_error if another program uses it.
  explicit SnapshotFolder(const Snapshot& snapshot);
  SnapshotFolder(const SnapshotFolder&) = delete;
  SnapshotFolder& operator=(const SnapshotFolder&) = delete;
  ~SnapshotFolder();

  /// Whether there is one, of this program or another.
  [[nodiscard]] static bool exists(const Snapshot& snapshot);

  /// Removes its contents.
  void clear();

 private:
  std::filesystem::path folder_;
  FolderLock lock_;
};

/// Whether a run to `until_s` that begins at a moment needs the past of it: false if it is complete in its folder or can be
/// resumed there.
[[nodiscard]] bool needs_snapshot(const std::filesystem::path& folder, double until_s);

/// Makes `folder` a copy of a run's folder up to its latest checkpoint of this version at or before `at_s`, from which another
/// run can be resumed. Does nothing if there is none: then that other run starts at time 0. Throws std::invalid_argument if
/// `folder` exists, std::runtime_error if a file cannot be copied.
void copy_until(const std::filesystem::path& run, double at_s, const std::filesystem::path& folder);

/// State of a run that begins at a moment: at that moment, in a copy that is made if the folder has no checkpoint, or later.
/// Without a past as the other `run_state_in`. Throws as that one and as `copy_until`, and std::invalid_argument
/// if the run in the folder began elsewhere.
[[nodiscard]] RunState run_state_in(const std::filesystem::path& folder, const observe::RunDescription& run,
                                    const std::optional<Snapshot>& snapshot, const Schedule& schedule = {});

/// Throws std::invalid_argument if an ecology cannot begin at a moment: living individuals may be beyond its bounds of traits.
void check_begins(const Snapshot& snapshot, Simulation& ecology);

/// Starts a run at a moment of another one. Throws as `restore_any`.
void begin_at(RunState& run_state, const Moment& moment, Simulation& ecology, io::Manifest& manifest, const Parts& parts);

}  // namespace trophic::checkpoint
