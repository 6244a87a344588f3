// SPDX-License-Identifier: MIT
// Type-erased interface of an experiment: one rule table on one backend.
#pragma once

#include <trophic/backend/backend_choice.hpp>
#include <trophic/control/brain/contract.hpp>
#include <trophic/ecology/history.hpp>
#include <trophic/ecology/lineup.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/population/null.hpp>
#include <trophic/rules/slot_rule.hpp>

namespace trophic {

/// Returns the response of a species' brain with these weights to these inputs, one whole number per act of its table: the tag
/// or, for other acts, whether the value is below (-1), at (0) or above (1) the middle of its bounds, such as the side of a turn;
/// for an act without bounds, its default. A brain with a State has its initial one. Throws std::invalid_argument for inputs or
/// weights that are invalid for the brain.
using AskBrain =
    std::function<std::vector<int>(Species species, std::span<const double> inputs, std::span<const double> weights)>;

/// Starts with the parameters of its rule table and backend.
class AnyExperiment {
 public:
  AnyExperiment() = default;
  AnyExperiment(const AnyExperiment&) = delete;
  AnyExperiment& operator=(const AnyExperiment&) = delete;
  virtual ~AnyExperiment() = default;

  /// The name of the rule table.
  [[nodiscard]] virtual std::string rule_table() const = 0;
  /// Returns an experiment with the same table and backend and default parameters.
  [[nodiscard]] virtual std::unique_ptr<AnyExperiment> fresh() const = 0;
  /// References to all parameters. Valid during the experiment's lifetime.
  [[nodiscard]] virtual ParamRefs params() = 0;
  [[nodiscard]] virtual std::uint64_t& seed() = 0;
  [[nodiscard]] virtual EcologyParams& ecology() = 0;
  [[nodiscard]] virtual Physics& physics() = 0;
  [[nodiscard]] virtual BackendChoice& backend() = 0;
  /// The backends that the table lists, its default first; empty for a table that runs on any.
  [[nodiscard]] virtual std::vector<std::string> backends() const = 0;
  /// The rules of its table.
  [[nodiscard]] virtual std::vector<rules::SlotRule> slot_rules() const = 0;
  /// Makes ecologies with the current parameters, under a null. `history`: for the neutral null, by seed.
  [[nodiscard]] virtual MakeSimulation simulations(const Null& null, const HistoryOf& history = {}) const = 0;
  /// Makes contests in the experiment's arena, with its brains and backend.
  [[nodiscard]] virtual MakeContest contests() const = 0;
  /// The brain of its table.
  [[nodiscard]] virtual AskBrain brain() const = 0;
};

/// Makes the experiment of one rule table on a backend.
using MakeExperiment = std::unique_ptr<AnyExperiment> (*)(const BackendChoice& backend);

}  // namespace trophic
