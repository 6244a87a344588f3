// SPDX-License-Identifier: MIT
// What runs of a set leave behind.
#pragma once

#include <cstdint>
#include <trophic/checkpoint/schedule.hpp>
#include <trophic/observe/manifest.hpp>
#include <trophic/observe/recording.hpp>

namespace trophic::replicates {

/// What runs of a set have in common beside their experiment.
struct Keeping {
  observe::Provenance provenance = {};
  checkpoint::Schedule checkpoints = {};
  double replay_hz = observe::default_replay_hz;  ///< frames of each run's recording in a simulated second; 0: none
  std::int64_t agents_every_ticks = 1;            ///< each agents.csv has the ticks whose number is a multiple of it
  bool senses = false;                            ///< each run leaves senses.csv too
};

}  // namespace trophic::replicates
