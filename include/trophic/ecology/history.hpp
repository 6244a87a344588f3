// SPDX-License-Identifier: MIT
// The events of a run, for a run that repeats them.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <trophic/observe/event.hpp>
#include <vector>

namespace trophic {

/// An event of a run, as in a row of events.csv. Switches of tags are none: brains decide on them.
struct Happening {
  std::int64_t tick = 0;
  observe::EventKind kind = observe::EventKind::birth;
  BodyIndex body = 0;
  IndividualId id = 0;
  Species species = 0;
  Origin origin = Origin::random;           ///< of a newborn
  std::optional<IndividualId> parent = {};  ///< of a newborn
  std::optional<Cause> cause = {};          ///< of a death
  std::optional<IndividualId> killer_or_victim = {};
};

/// The events of a run in their order. The neutral null repeats them, whatever its robots do: births, deaths, parents,
/// activations and catches are those of the run, with genomes of its own. Behaviour has no effect on lengths of life and numbers
/// of offspring, so neither survival nor parenthood selects: genomes change by mutation and chance alone. Tags are not repeated,
/// as brains choose them.
using History = std::vector<Happening>;
using SharedHistory = std::shared_ptr<const History>;

/// Reads the history that the neutral null of a seed repeats.
using HistoryOf = std::function<SharedHistory(std::uint64_t seed)>;

}  // namespace trophic
