// SPDX-License-Identifier: MIT
// The rule tables that trophic ships, compiled once.
#pragma once

#include <string>
#include <trophic/experiment/any_experiment.hpp>
#include <utility>
#include <vector>

namespace trophic::command {

/// The tables of trophic-worlds, by name, as an Offer has them.
[[nodiscard]] std::vector<std::pair<std::string, MakeExperiment>> world_tables();

/// Every table: those of trophic-predator-prey, then those of trophic-worlds.
[[nodiscard]] std::vector<std::pair<std::string, MakeExperiment>> shipped_tables();

}  // namespace trophic::command
