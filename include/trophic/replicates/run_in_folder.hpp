// SPDX-License-Identifier: MIT
// One run of several into its own folder.
#pragma once

#include <filesystem>
#include <trophic/checkpoint/go_on.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/observe/joint_progress.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/observe/run_folder.hpp>
#include <trophic/observe/state_columns.hpp>
#include <trophic/observe/stop_on_signal.hpp>
#include <trophic/replicates/keeping.hpp>

namespace trophic::replicates {

/// Runs an experiment for its `ecology.duration_s` into a folder, from its beginning or from the checkpoint that is there, or
/// until a signal comes; the manifest says which. `extra...` observe it. Throws as the ecology, standing_in and run_kept do.
template <class Rules, Backend B, class... Observers>
void run_in_folder(const Experiment<Rules, B>& experiment, const std::filesystem::path& folder, const Keeping& keeping,
                   observe::JointProgress::Part progress, const observe::StopOnSignal& stop, Observers&... extra) {
  const double until_s = experiment.ecology.duration_s;
  Ecology<Rules, B> ecology{experiment};
  const checkpoint::Standing standing = checkpoint::standing_in(folder, ecology.describe(until_s));
  observe::RunFolder files{folder, keeping.provenance, keeping.extent, standing.opening(),
                           observe::state_columns(ecology.states())};
  checkpoint::run_kept(ecology, until_s, folder, keeping.checkpoints, standing.from, files, progress, stop, extra...);
  files.manifest().add({{"wall_s", observe::short_text(progress.elapsed_s())}});
}

}  // namespace trophic::replicates
