// SPDX-License-Identifier: MIT
// Runs the replicates of an experiment in parallel, each into its own folder.
#pragma once

#include <ostream>
#include <tools/replicates/common_options.hpp>
#include <tools/replicates/joint_progress.hpp>
#include <tools/replicates/plan.hpp>
#include <tools/replicates/run_in_folder.hpp>
#include <tools/replicates/stop_on_signal.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/ecology/simulations_of.hpp>
#include <trophic/io/manifest.hpp>

namespace trophic::replicates {

/// State of the set after a call of run.
struct Outcome {
  std::size_t kept = 0;                 ///< complete at the start
  std::size_t complete = 0;             ///< completed by this call
  std::vector<std::string> unfinished;  ///< a sentence for each that failed, was stopped or was not started
};

/// Makes one run of a set, in its folder.
using RunOne = std::function<void(const Replicate& replicate, const CommonOptions& common,
                                  replicates::JointProgress::Part progress, const replicates::StopOnSignal& stop)>;

/// Makes those runs of a plan that are not complete. `run`: any of them, as it describes itself. See `run`.
[[nodiscard]] Outcome run_pending(const Plan& plan, const observe::RunDescription& run, const io::Provenance& provenance,
                                  std::ostream& out, const RunOne& run_one);

/// Runs `plan.count` replicates of an experiment to `until_s`, `plan.jobs` at a time, each with its own seed into its own folder,
/// with checkpoints; reports each that ends on `out`. Replicates share no data: one that fails or is killed does not change the
/// others, and results depend neither on `jobs` nor on interruptions of the set. SIGINT and SIGTERM end the running ones and
/// start no more. Throws as Folder does, and as `make` does for a bad number, before anything is simulated. `extra...` observe
/// every replicate, from several threads.
template <class... Observers>
Outcome run(const MakeSimulation& make, double until_s, const Plan& plan, const io::Provenance& provenance, std::ostream& out,
            Observers&... extra) {
  plan.check();
  return run_pending(plan, make(plan.master_seed)->describe(until_s), provenance, out,
                     [&](const Replicate& replicate, const CommonOptions& common, replicates::JointProgress::Part progress,
                         const replicates::StopOnSignal& stop) {
                       static_cast<void>(run_in_folder(*make(replicate.seed), until_s, replicate.folder, common,
                                                       {std::move(progress), stop}, extra...));
                     });
}

/// Replicates of an experiment on a backend, for its `ecology.duration_s`.
template <class Rules, class... Observers>
Outcome run(const Experiment<Rules>& experiment, const BackendChoice& backend, const Plan& plan, const io::Provenance& provenance,
            std::ostream& out, Observers&... extra) {
  return run(simulations_of(experiment, backend), experiment.ecology.duration_s, plan, provenance, out, extra...);
}

}  // namespace trophic::replicates
