// SPDX-License-Identifier: MIT
// The ecologies of one experiment that differ only in their seed.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/ecology/checked_experiment.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/shipped.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <utility>

namespace trophic {

/// Makes ecologies of these numbers that differ only in their seed. The result throws as the ecology's constructor does.
template <class Rules>
[[nodiscard]] MakeSimulation simulations_of(const Experiment<Rules>& experiment, const BackendChoice& backend) {
  return [experiment, backend](std::uint64_t seed) {
    Experiment<Rules> own = experiment;
    own.seed = seed;
    return std::make_unique<Ecology<Rules>>(std::move(own), backend);
  };
}

/// Makes contests in the arena of these numbers, which is loaded once. Throws as the ecology's constructor does.
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

}  // namespace trophic
