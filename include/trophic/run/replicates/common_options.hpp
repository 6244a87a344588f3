// SPDX-License-Identifier: MIT
// What runs of a set leave behind.
#pragma once

#include <cstdint>
#include <optional>
#include <trophic/io/manifest.hpp>
#include <trophic/io/own_table.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/run/checkpoint/rewind.hpp>
#include <trophic/run/checkpoint/schedule.hpp>

namespace trophic::replicates {

/// What runs of a set have in common beside their experiment.
struct CommonOptions {
  io::Provenance provenance = {};
  checkpoint::Schedule checkpoints = {};
  io::OutputOptions output = {};                      ///< how much of each run is written down
  std::optional<checkpoint::Snapshot> snapshot = {};  ///< of a run at a moment of which they all begin
  io::OwnTables own_tables = {};                      ///< that each run writes, too
};

}  // namespace trophic::replicates
