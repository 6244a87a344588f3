// SPDX-License-Identifier: MIT
// The ecologies of one experiment that differ only in their seed.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/control/brain/contract.hpp>
#include <trophic/ecology/ask_brain.hpp>
#include <trophic/ecology/checked_experiment.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/shipped.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/table.hpp>
#include <utility>

namespace trophic {

/// Makes ecologies of these parameters that differ only in their seed. The result throws as the ecology's constructor does.
template <class Rules>
[[nodiscard]] MakeSimulation simulations_of(const Experiment<Rules>& experiment, const BackendChoice& backend) {
  return [experiment, backend](std::uint64_t seed) {
    Experiment<Rules> own = experiment;
    own.seed = seed;
    return std::make_unique<Ecology<Rules>>(std::move(own), backend);
  };
}

/// Makes contests in the arena of these parameters, which is loaded once. Throws as the ecology's constructor does.
template <class Rules>
[[nodiscard]] MakeContest contests_of(const Experiment<Rules>& experiment, const BackendChoice& backend,
                                      std::string_view installed = TROPHIC_MODEL_DIR) {
  const auto loaded = std::make_shared<const CheckedExperiment<Rules>>(load_checked(experiment, backend, installed));
  return [loaded](std::uint64_t places, Lineup lineup) {
    Experiment<Rules> own = loaded->params;
    own.seed = places;
    own.ecology.robots = lineup.size();
    own.lineup = std::move(lineup);
    return std::make_unique<Ecology<Rules>>(std::move(own), loaded->backend, loaded->habitat);
  };
}

/// The brain of these parameters. The result throws std::invalid_argument for inputs or weights that the brain does not take.
template <class Rules>
[[nodiscard]] AskBrain ask_brain(const Experiment<Rules>& experiment) {
  using Brain = PolicyIn<Rules, RuleSlot::brain>;
  return [brain = make_policies<Rules>(experiment.rules).brain](std::span<const double> inputs, std::span<const double> weights) {
    constexpr std::size_t taken = PolicyIn<Rules, RuleSlot::sensors>::size;
    const auto check = [](bool good, std::string_view what, std::size_t given, const std::string& must) {
      if (good) return;
      throw std::invalid_argument{std::string{what} + ": " + std::to_string(given) + ": must be " + must +
                                  ", as the rule table's brain takes"};
    };
    check(inputs.size() == taken, "inputs", inputs.size(), std::to_string(taken));
    check(control::ask::fits(brain, weights, taken), "weights", weights.size(), control::ask::demand(brain, taken));
    StateOf<Brain> own{};
    return control::ask::decide(brain, own, inputs, weights);
  };
}

}  // namespace trophic
