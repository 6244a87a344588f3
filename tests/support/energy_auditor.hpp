// SPDX-License-Identifier: MIT
// The ledger of energy, audited.
#pragma once

#include <algorithm>
#include <trophic/population/view.hpp>

namespace trophic::test {

/// Compares the stock of each species and of the resource with the last one and the ledger.
struct EnergyAuditor {
  void on_tick(const View& view) {
    std::vector<double> now_J(view.web.size());
    for (const Individual& one : view.robots) {
      if (one.lives()) now_J[one.species] += one.energy_J;
    }
    const double most_J = std::max(1.0, *std::ranges::max_element(now_J));
    for (Species species = 0; species < now_J.size(); ++species) {
      const double before_J = stock_J.empty() ? 0.0 : stock_J[species];
      worst = std::max(worst, std::abs(now_J[species] - before_J - view.energy[species].sum_J()) / most_J);
      turned_over_J += view.energy[species].upkeep_J;
    }
    if (view.field != nullptr) {
      const double now_there_J = view.field->total_J();
      const ResourceFlow& flow = view.resource;
      if (view.tick > 0)
        worst = std::max(worst, std::abs(now_there_J - there_J - flow.grown_J + flow.taken_J) / std::max(1.0, now_there_J));
      there_J = now_there_J;
    }
    stock_J = now_J;
  }
  std::vector<double> stock_J = {};
  double there_J = 0.0;
  double worst = 0.0;
  double turned_over_J = 0.0;
};

}  // namespace trophic::test
