// SPDX-License-Identifier: MIT
// One run of several into its own folder.
#pragma once

#include <filesystem>
#include <trophic/ecology/simulation.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/observe/joint_progress.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/observe/stop_on_signal.hpp>
#include <trophic/run/checkpoint/go_on.hpp>
#include <trophic/run/checkpoint/rewind.hpp>
#include <trophic/run/replicates/keeping.hpp>

namespace trophic::replicates {

/// Runs an ecology that has not begun to `until_s` into a folder, from its beginning, from the moment of another run at which it
/// begins or from the checkpoint that is there, until a signal comes; the manifest says which. `extra...` observe it. Throws as
/// standing_in and run_kept do.
template <class... Observers>
void run_in_folder(Simulation& ecology, double until_s, const std::filesystem::path& folder, const Keeping& keeping,
                   observe::JointProgress::Part progress, const observe::StopOnSignal& stop, Observers&... extra) {
  checkpoint::Standing standing =
      checkpoint::standing_in(folder, ecology.describe(until_s), keeping.past, keeping.checkpoints.other_build);
  io::RunFolder files{
      folder, keeping.provenance, keeping.extent, standing.opening(), ecology.state_columns(), keeping.own_tables};
  if (standing.begins) {
    checkpoint::begin_at(standing, keeping.past->moment, ecology, files.manifest(),
                         checkpoint::parts_of(files, progress, stop, extra...));
  }
  checkpoint::run_kept(ecology, until_s, folder, keeping.checkpoints, standing.from, files, progress, stop, extra...);
  files.manifest().add({{"wall_s", observe::short_text(progress.elapsed_s())}});
}

}  // namespace trophic::replicates
