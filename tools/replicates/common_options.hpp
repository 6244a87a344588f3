// SPDX-License-Identifier: MIT
// Output and other options that runs of a set have in common.
#pragma once

#include <tools/replicates/rewind.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/run/checkpoint/schedule.hpp>

namespace trophic::replicates {

/// Options that runs of a set have in common, besides their experiment.
struct CommonOptions {
  io::Provenance provenance = {};
  checkpoint::Schedule checkpoints = {};
  io::OutputOptions output = {};                      ///< how much of each run is written
  std::optional<checkpoint::Snapshot> snapshot = {};  ///< of a run at a moment of which they all begin
  io::OwnTablesOf own_tables = {};                    ///< written by each run
};

}  // namespace trophic::replicates
