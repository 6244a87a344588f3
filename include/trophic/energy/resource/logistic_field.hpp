// SPDX-License-Identifier: MIT
// Food that grows logistically in every cell, with a seasonal growth rate.
#pragma once

#include <trophic/energy/resource/contract.hpp>

namespace trophic::energy::resource {

/// Rule, for the food F of a cell in a tick of length t:
///   F <- min(K, F + t (r F (1 - F / K) + seed K)),   r = growth (1 + season sin(2 pi time / year)),   K = capacity * area of the
///   cell
/// Each cell starts full. A random share `barren` of the cells never has food; their capacity is shared by the others. This is
/// Verhulst's growth [rosenzweig1963]; `seed` lets an empty cell recover. All parameters are free. Reads: time.   Random draws:
/// one per cell at the start if there are barren cells.
struct LogisticField {
  static constexpr std::string_view name = "logistic_field";
  static constexpr std::string_view source = "not in the paper; growth as in [rosenzweig1963]";

  struct Params {
    std::size_t cells_in_a_row = 20;
    double capacity_J_m2 = 10.0;
    double growth_1_s = 0.01;
    double seed_1_s = 0.0001;
    double barren = 0.0;
    double season = 0.5;
    double year_s = 1000.0;
    static constexpr auto fields() {
      return std::tuple{
          field("cells_in_a_row", &Params::cells_in_a_row, between(1, 1000), "number of cells along a side of the arena")
              .read_at_start(),
          field("capacity_J_m2", &Params::capacity_J_m2, at_least(0.0), "mean carrying capacity per square metre")
              .read_at_start(),
          field("growth_1_s", &Params::growth_1_s, at_least(0.0), "growth rate at low density"),
          field("seed_1_s", &Params::seed_1_s, at_least(0.0), "growth per second at any density, as a fraction of the capacity"),
          field("barren", &Params::barren, between(0.0, 0.99), "share of barren cells, which never have food").read_at_start(),
          field("season", &Params::season, between(0.0, 1.0), "amplitude of seasonal changes in the growth rate"),
          field("year_s", &Params::year_s, above(0.0), "length of a year by the ecology's clock")};
    }
  };
  Params params;

  [[nodiscard]] std::string_view why_no_effect(std::string_view number, const FoodWeb&, OneSpecies) const {
    return number == "year_s" && params.season == 0.0 ? "without a season" : "";
  }

  /// Layer 0 holds the capacity of each cell.
  [[nodiscard]] ResourceField start(const Arena& arena, Rng& rng) const {
    ResourceField field{arena, params.cells_in_a_row, 1};
    const double cell_J = params.capacity_J_m2 * field.cell_m() * field.cell_m() / (1.0 - params.barren);
    for (std::size_t cell = 0; cell < field.cells(); ++cell) {
      const bool bears = params.barren <= 0.0 || !rng.chance(params.barren);
      field.layer(0, cell) = field.food_J(cell) = bears ? cell_J : 0.0;
    }
    return field;
  }

  void grow(ResourceField& field, const View& view, Rng&) const {
    const double season = 1.0 + params.season * std::sin(2.0 * std::numbers::pi * view.time_s / params.year_s);
    for (std::size_t cell = 0; cell < field.cells(); ++cell) {
      double& food_J = field.food_J(cell);
      const double most_J = field.layer(0, cell);
      if (most_J <= 0.0) continue;
      const double growth_J = params.growth_1_s * season * food_J * (1.0 - food_J / most_J) + params.seed_1_s * most_J;
      food_J = std::min(most_J, food_J + view.tick_s * growth_J);
    }
  }
};
static_assert(Resource<LogisticField>);

}  // namespace trophic::energy::resource
