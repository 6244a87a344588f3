// SPDX-License-Identifier: MIT
// Replicates of an experiment and of its nulls.
#pragma once

#include <ostream>
#include <tools/reading/read_history.hpp>
#include <tools/replicates/plan.hpp>
#include <tools/replicates/run.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/ecology/simulations_of.hpp>

namespace trophic::replicates {

/// An experiment, or its null, as replicates are made of it.
struct SetOfRuns {
  Null null = Null::none;
  MakeSimulation make;
};

/// Runs the replicates of each set to `until_s` as `run` does, with the same seeds, those of nulls into folders of `plan.out`. A
/// set begins when the one before is complete. Returns a sentence for each incomplete replicate.
std::vector<std::string> run_with_nulls(std::span<const SetOfRuns> sets, double until_s, const Plan& plan,
                                        const io::Provenance& provenance, std::ostream& out);

/// The histories that the neutral null of a plan's runs repeats, once these are complete.
[[nodiscard]] inline HistoryOf histories_of(const Plan& plan) {
  return [all = plan.all()](std::uint64_t seed) -> SharedHistory {
    const auto of = std::ranges::find(all, seed, &Replicate::seed);
    return of == all.end() ? nullptr : read_history(of->folder);  // none: to be described, not run
  };
}

/// Runs an experiment on a backend for its `ecology.duration_s`, and under these nulls.
template <class Rules>
std::vector<std::string> run_with_nulls(const Experiment<Rules>& experiment, const BackendChoice& backend, const Plan& plan,
                                        std::span<const Null> nulls, const io::Provenance& provenance, std::ostream& out) {
  std::vector<SetOfRuns> sets{{Null::none, simulations_of(experiment, backend)}};
  for (const Null& null : nulls)
    sets.push_back(
        {null, simulations_of(under(null, experiment), backend, null == Null::neutral ? histories_of(plan) : HistoryOf{})});
  return run_with_nulls(sets, experiment.ecology.duration_s, plan, provenance, out);
}

}  // namespace trophic::replicates
