// SPDX-License-Identifier: MIT
// One run of several into its own folder.
#pragma once

#include <filesystem>
#include <trophic/ecology/simulation.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/observe/joint_progress.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/observe/stop_on_signal.hpp>
#include <trophic/run/changes/changing_simulation.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/run/checkpoint/rewind.hpp>
#include <trophic/run/replicates/common_options.hpp>

namespace trophic::replicates {

/// Runs an ecology that has not begun to `until_s` into a folder, from its beginning, from the moment of another run at which it
/// begins or from the folder's checkpoint, until a signal comes; the manifest has the origin. `extra...` observe it. Throws as
/// run_state_in and run_with_checkpoints do.
template <class... Observers>
void run_in_folder(Simulation& ecology, double until_s, const std::filesystem::path& folder, const CommonOptions& common,
                   observe::JointProgress::Part progress, const observe::StopOnSignal& stop, Observers&... extra) {
  checkpoint::RunState run_state =
      checkpoint::run_state_in(folder, ecology.describe(until_s), common.snapshot, common.checkpoints.other_build);
  io::RunFolder files{folder,
                      common.provenance,
                      common.output,
                      run_state.opening(),
                      ecology.state_columns(),
                      changes::with_changes(common.own_tables, ecology)};
  if (run_state.begins) {
    checkpoint::begin_at(run_state, common.snapshot->moment, ecology, files.manifest(),
                         checkpoint::parts_of(files, progress, stop, extra...));
  }
  checkpoint::run_with_checkpoints(ecology, until_s, folder, common.checkpoints, run_state.from, files, progress, stop, extra...);
  files.manifest().add({{"wall_s", observe::short_text(progress.elapsed_s())}});
}

}  // namespace trophic::replicates
