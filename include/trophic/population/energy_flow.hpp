// SPDX-License-Identifier: MIT
// The ledger of energy: transfers between the resource, the individuals and the outside since the last tick.
#pragma once

#include <algorithm>
#include <tuple>

namespace trophic {

/// The energy of a species since the last tick, J. Its stock changes by
///   outside_J + field_J + victims_J + received_J - upkeep_J - eaten_J - given_J - lost_J.
struct EnergyFlow {
  double outside_J = 0.0;   ///< gained by founders and newcomers, which no parent endows, as bonuses for catches, and as grants
  double field_J = 0.0;     ///< taken from the resource
  double victims_J = 0.0;   ///< gained from caught victims
  double received_J = 0.0;  ///< gained by newborns from their parents
  double upkeep_J = 0.0;    ///< spent on living and walking
  double eaten_J = 0.0;     ///< lost to the hunters that caught members
  double given_J = 0.0;     ///< given by parents to newborns
  double lost_J = 0.0;      ///< lost with the dead
  static constexpr auto saved() {
    return std::tuple{&EnergyFlow::outside_J, &EnergyFlow::field_J, &EnergyFlow::victims_J, &EnergyFlow::received_J,
                      &EnergyFlow::upkeep_J,  &EnergyFlow::eaten_J, &EnergyFlow::given_J,   &EnergyFlow::lost_J};
  }
  /// The change in the stock.
  [[nodiscard]] double sum_J() const {
    return outside_J + field_J + victims_J + received_J - upkeep_J - eaten_J - given_J - lost_J;
  }
};

/// The energy of a food of the resource since the last tick, J. Its stock changes by grown_J - taken_J - destroyed_J.
struct ResourceFlow {
  double grown_J = 0.0;  ///< grown by the rule Resource and its hooks
  double taken_J = 0.0;  ///< taken by individuals
  double destroyed_J =
      0.0;  ///< destroyed by eaters, by the rule Resource and its hooks: waste, decay, the rest of a bitten patch

  /// Adds what the rule Resource changes in a cell.
  void note(double change_J) {
    grown_J += std::max(change_J, 0.0);
    destroyed_J += std::max(-change_J, 0.0);
  }
  static constexpr auto saved() { return std::tuple{&ResourceFlow::grown_J, &ResourceFlow::taken_J, &ResourceFlow::destroyed_J}; }
};

}  // namespace trophic
