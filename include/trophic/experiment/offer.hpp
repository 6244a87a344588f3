// SPDX-License-Identifier: MIT
// The offer of an experiment program: rule tables and backends, any table on any backend, and the program's own additions.
#pragma once

#include <trophic/backend/backend_choice.hpp>
#include <trophic/experiment/any_experiment.hpp>
#include <trophic/io/own_table.hpp>

namespace trophic {

/// Tables that every run writes, including shadows and runs of plans; backends, the first of them the default.
struct Offer {
  io::OwnTables tables = {};
  std::vector<BackendChoice> backends = {};  ///< if empty, kinematic and all engines with which trophic was built
  std::string default_backend = {};  ///< if empty, the first backend, or "mujoco" if there are none; need not be among them
  std::vector<std::pair<std::string, MakeExperiment>> rule_tables = {};  ///< by name, the default first; set by `experiment`
};

}  // namespace trophic
