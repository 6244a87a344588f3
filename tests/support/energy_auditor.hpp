// SPDX-License-Identifier: MIT
// The ledger of energy, audited.
#pragma once

#include <algorithm>
#include <trophic/population/view.hpp>

namespace trophic::test {

/// Compares the stock of each species and food with the last one and the ledger, and what species ate with what foods lost.
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
    there_J.resize(view.foods.size());
    double eaten_J = 0.0;
    for (std::size_t food = 0; food < view.foods.size(); ++food) {
      const double now_there_J = view.foods[food].total_J();
      const ResourceFlow& flow = view.resource[food];
      const double change_J = flow.grown_J - flow.taken_J - flow.destroyed_J;
      if (view.tick > 0) worst = std::max(worst, std::abs(now_there_J - there_J[food] - change_J) / std::max(1.0, now_there_J));
      there_J[food] = now_there_J;
      eaten_J += flow.taken_J;
    }
    for (const EnergyFlow& flow : view.energy) eaten_J -= flow.field_J;
    worst = std::max(worst, std::abs(eaten_J) / most_J);
    stock_J = now_J;
  }
  std::vector<double> stock_J = {};
  std::vector<double> there_J = {};  ///< of each food
  double worst = 0.0;
  double turned_over_J = 0.0;
};

}  // namespace trophic::test
