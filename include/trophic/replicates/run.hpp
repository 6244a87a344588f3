// SPDX-License-Identifier: MIT
// Runs the replicates of an experiment in parallel, each into its own folder.
#pragma once

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <string>
#include <trophic/checkpoint/go_on.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/observe/joint_progress.hpp>
#include <trophic/observe/run_folder.hpp>
#include <trophic/observe/stop_on_signal.hpp>
#include <trophic/replicates/folder.hpp>
#include <trophic/replicates/parallel.hpp>
#include <trophic/replicates/plan.hpp>
#include <trophic/replicates/run_in_folder.hpp>
#include <vector>

namespace trophic::replicates {

/// How the set stands after a call of run.
struct Outcome {
  std::size_t kept = 0;                 ///< were complete before
  std::size_t complete = 0;             ///< ran to their end now
  std::vector<std::string> unfinished;  ///< a sentence for each that failed, was stopped or was not started
  [[nodiscard]] bool all_complete() const { return unfinished.empty(); }
};

/// Runs `plan.count` replicates of the experiment for its `ecology.duration_s`, `plan.jobs` at a time, each with its own seed
/// into its own folder, with checkpoints; tells `out` of each that ends. Replicates share nothing: one that fails or is killed
/// leaves the others as they are, and results depend neither on `jobs` nor on how often the set was cut off. SIGINT and SIGTERM
/// end those at hand and start no more. Throws as Folder does, and as the ecology does for a bad number, before anything is
/// simulated. `extra...` observe every replicate, from several threads.
template <class Rules, Backend B, class... Observers>
Outcome run(const Experiment<Rules, B>& experiment, const Plan& plan, const observe::Provenance& provenance, std::ostream& out,
            Observers&... extra) {
  plan.check();
  const double until_s = experiment.ecology.duration_s;
  const observe::RunDescription description = Ecology<Rules, B>{experiment}.describe(until_s);
  const Folder folder{plan, description, provenance};
  for (const std::string& remark : description.remarks) out << remark << "\n";
  for (const std::string& remark : folder.remarks()) out << remark << "\n";
  if (folder.kept() > 0) out << folder.kept() << " of " << plan.count << " were complete and are kept" << std::endl;

  const auto& pending = folder.pending();
  const observe::StopOnSignal stop;
  observe::JointProgress progress{pending.size(), until_s, out};
  const auto run_one = [&](std::size_t i) {
    const Replicate& replicate = pending[i];
    Experiment<Rules, B> own = experiment;
    own.seed = replicate.seed;
    Keeping keeping{provenance, plan.checkpoints, plan.extent};
    keeping.provenance.emplace_back("master_seed", std::to_string(plan.master_seed));
    keeping.provenance.emplace_back("replicate", std::to_string(replicate.index));
    run_in_folder(own, replicate.folder, keeping, progress.watch(name_of(replicate.index)), stop, extra...);
  };
  const auto attempts = in_parallel(pending.size(), plan.jobs, run_one, [&] { return stop.keep_running(); });

  Outcome outcome{.kept = folder.kept(), .complete = 0, .unfinished = {}};
  for (std::size_t i = 0; i < pending.size(); ++i) {
    const std::string name = name_of(pending[i].index);
    const std::string status = status_of(pending[i].folder);
    if (!attempts[i].started) {
      outcome.unfinished.push_back(name + ": not started");
    } else if (!attempts[i].error.empty()) {
      outcome.unfinished.push_back(name + ": " + attempts[i].error);
    } else if (status != "complete") {
      outcome.unfinished.push_back(name + ": " + status);
    } else {
      ++outcome.complete;
    }
  }
  return outcome;
}

}  // namespace trophic::replicates
