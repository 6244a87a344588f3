// SPDX-License-Identifier: MIT
// Replicates of an experiment and of its neutral shadow.
#pragma once

#include <ostream>
#include <string>
#include <trophic/ecology/shadow_of.hpp>
#include <trophic/replicates/plan.hpp>
#include <trophic/replicates/run.hpp>
#include <trophic/rules/neutral_shadow.hpp>
#include <utility>
#include <vector>

namespace trophic::replicates {

namespace detail {

template <class Rules, Backend B>
std::vector<std::string> run_and_tell(const Experiment<Rules, B>& experiment, const Plan& plan,
                                      const observe::Provenance& provenance, std::ostream& out) {
  Outcome outcome = run<Rules, B>(experiment, plan, provenance, out);
  out << outcome.kept + outcome.complete << " of " << plan.count << " replicates complete in " << plan.out.string() << std::endl;
  return std::move(outcome.unfinished);
}

}  // namespace detail

/// Runs the replicates of an experiment as `run` does and, where asked, those of its neutral shadow with the same seeds into
/// `plan.out`/shadow. The shadow waits for a set that is complete. A sentence for each replicate that is not.
template <class Rules, Backend B>
std::vector<std::string> run_with_shadow(const Experiment<Rules, B>& experiment, const Plan& plan, bool with_shadow,
                                         const observe::Provenance& provenance, std::ostream& out) {
  auto unfinished = detail::run_and_tell<Rules, B>(experiment, plan, provenance, out);
  if (!with_shadow || !unfinished.empty()) return unfinished;
  Plan beside = plan;
  beside.out /= "shadow";
  unfinished = detail::run_and_tell<rules::neutral_shadow<Rules>, B>(shadow_of(experiment), beside, provenance, out);
  for (std::string& sentence : unfinished) sentence.insert(0, "shadow/");
  return unfinished;
}

}  // namespace trophic::replicates
