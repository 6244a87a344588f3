// SPDX-License-Identifier: MIT
// The opponents in contests across generations and their places, drawn anew for each replicate.
#pragma once

#include <cstdint>
#include <trophic/population/food_web.hpp>

namespace trophic::contest {

/// A team of one replicate, epoch and species.
struct TeamName {
  std::size_t replicate = 0;
  std::size_t epoch = 0;
  Species species = 0;
  std::size_t team = 0;  ///< of `teams` an epoch
};

/// The random part of contests. A team meets the teams of its number of all epochs, at the same places, so that a difference
/// between epochs is not one of opponents or places. Teams, partners and places are drawn for each replicate: drawn alike in all,
/// their errors would not cancel over replicates, and no interval would show them. The shadow of a replicate has its places.
class ContestDesign {
 public:
  /// @param replicates at least 1. @param teams of each species an epoch; at least 1.
  ContestDesign(std::uint64_t seed, std::size_t replicates, std::size_t teams);

  /// Draws `size` of `living` individuals, all of them before any twice.
  [[nodiscard]] std::vector<std::size_t> members(const TeamName& team, bool shadow, std::size_t living, std::size_t size) const;

  /// The replicate whose victims the hunters of this one meet, never itself; each replicate is the partner of exactly one. Throws
  /// std::invalid_argument with fewer than two replicates.
  [[nodiscard]] std::size_t partner(std::size_t replicate, std::size_t team) const;

  /// The seed of an arena's places.
  [[nodiscard]] std::uint64_t places(std::size_t replicate, std::size_t team) const;

  [[nodiscard]] std::size_t replicates() const { return replicates_; }
  [[nodiscard]] std::size_t teams() const { return teams_; }

 private:
  std::uint64_t seed_;
  std::size_t replicates_;
  std::size_t teams_;
};

}  // namespace trophic::contest
