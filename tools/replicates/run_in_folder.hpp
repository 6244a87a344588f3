// SPDX-License-Identifier: MIT
// One run of several into its own folder.
#pragma once

#include <tools/replicates/common_options.hpp>
#include <tools/replicates/joint_progress.hpp>
#include <tools/replicates/rewind.hpp>
#include <tools/replicates/stop_on_signal.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/run/checkpoint/resume.hpp>

namespace trophic::replicates {

/// Adds the wall time of an ecology that has run to its manifest, and what its engine remarks on its speed, or if `asked` on its
/// steps. Returns that remark, which may be empty.
inline std::string add_speed(io::Manifest& manifest, double wall_s, const Simulation& ecology, bool asked = false) {
  io::Provenance speed{{"wall_s", observe::short_text(wall_s)}};
  std::string remark = ecology.backend().speed_remark(asked);
  if (!remark.empty()) speed.emplace_back("speed", remark);
  manifest.add(speed);
  return remark;
}

/// The progress display of a run, and the signals that stop it.
struct Watch {
  replicates::JointProgress::Part progress;
  const replicates::StopOnSignal& stop;
};

/// Runs an ecology that has not begun to `until_s` into a folder, from its beginning, from the moment of another run at which it
/// begins or from the folder's checkpoint, until a signal comes; the manifest has the origin. `extra...` observe it. Returns the
/// remark of run_state_in, which may be empty. Throws as run_state_in and run_with_checkpoints do.
template <class... Observers>
std::string run_in_folder(Simulation& ecology, double until_s, const std::filesystem::path& folder, const CommonOptions& common,
                          Watch watch, Observers&... extra) {
  const observe::RunDescription run = ecology.describe(until_s);
  checkpoint::RunState run_state = checkpoint::run_state_in(folder, run, common.snapshot, common.checkpoints);
  if (run_state.complete) return run_state.remark;
  io::RunFolder files{folder,
                      common.provenance,
                      common.output,
                      run_state.opening(),
                      ecology.state_columns(),
                      common.own_tables ? common.own_tables(ecology) : io::OwnTables{}};
  if (run_state.begins) {
    checkpoint::begin_at(run_state, common.snapshot->moment, ecology, files.manifest(),
                         checkpoint::parts_of(files, watch.progress, watch.stop, extra...));
  }
  checkpoint::run_with_checkpoints(ecology, until_s, folder, common.checkpoints, run_state.from, files, watch.progress,
                                   watch.stop, extra...);
  add_speed(files.manifest(), watch.progress.elapsed_s(), ecology);
  return run_state.remark;
}

}  // namespace trophic::replicates
