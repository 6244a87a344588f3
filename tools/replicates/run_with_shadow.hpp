// SPDX-License-Identifier: MIT
// Replicates of an experiment and of its neutral shadow.
#pragma once

#include <ostream>
#include <tools/replicates/plan.hpp>
#include <tools/replicates/run.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/ecology/simulations_of.hpp>

namespace trophic::replicates {

/// Runs the replicates of an experiment to `until_s` as `run` does and then, with `shadow`, those of its neutral shadow with the
/// same seeds into `plan.out`/shadow. The shadow begins when the set is complete. Returns a sentence for each incomplete
/// replicate.
std::vector<std::string> run_with_shadow(const MakeSimulation& make, const MakeSimulation& shadow, double until_s,
                                         const Plan& plan, const io::Provenance& provenance, std::ostream& out);

/// Runs an experiment on a backend for its `ecology.duration_s`.
template <class Rules>
std::vector<std::string> run_with_shadow(const Experiment<Rules>& experiment, const BackendChoice& backend, const Plan& plan,
                                         bool with_shadow, const io::Provenance& provenance, std::ostream& out) {
  return run_with_shadow(simulations_of(experiment, backend),
                         with_shadow ? simulations_of(shadow_of(experiment), backend) : nullptr, experiment.ecology.duration_s,
                         plan, provenance, out);
}

}  // namespace trophic::replicates
