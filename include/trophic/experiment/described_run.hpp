// SPDX-License-Identifier: MIT
// The run that a description names: rule table, engine, parameters, seed and null. Link trophic::command, which has the
// definitions.
#pragma once

#include <memory>
#include <trophic/experiment/offer.hpp>
#include <trophic/population/null.hpp>
#include <trophic/support/json.hpp>

namespace trophic {

/// A run that a description names.
struct DescribedRun {
  std::unique_ptr<AnyExperiment> experiment;  ///< with the parameters of the description
  Null null;

  /// Its ecology. Throws as the ecology's constructor does.
  [[nodiscard]] std::unique_ptr<Simulation> simulation() const { return experiment->simulations(null)(experiment->seed()); }
};

/// Reads a description: a JSON object with what a configuration file has (`--print-config`), each parameter in its nested object
/// or under its path, and optionally a null:
///   {"rule_table": "pond", "engine": "kinematic", "seed": 1, "ecology": {"robots": 60}, "rules.mutation.sd": 0.1,
///    "null": "shadow"}
/// What it leaves out is the default of the offer, the table or the engine, as on the command line; an engine has one thread. An
/// offer without backends has those that trophic was built with. Throws std::invalid_argument naming field, value and bound.
[[nodiscard]] DescribedRun described_run(const Json& description, const Offer& offer);

}  // namespace trophic
