// SPDX-License-Identifier: MIT
// What runs of a set leave behind.
#pragma once

#include <cstdint>
#include <optional>
#include <trophic/checkpoint/rewind.hpp>
#include <trophic/checkpoint/schedule.hpp>
#include <trophic/observe/manifest.hpp>
#include <trophic/observe/own_table.hpp>
#include <trophic/observe/run_folder.hpp>

namespace trophic::replicates {

/// What runs of a set have in common beside their experiment.
struct Keeping {
  observe::Provenance provenance = {};
  checkpoint::Schedule checkpoints = {};
  observe::Extent extent = {};                ///< how much of each run is written down
  std::optional<checkpoint::Past> past = {};  ///< of a run at a moment of which they all begin
  observe::OwnTables own_tables = {};         ///< that each run writes, too
};

}  // namespace trophic::replicates
