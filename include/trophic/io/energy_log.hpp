// SPDX-License-Identifier: MIT
// energy.csv, resource.csv and field.csv: the ledger of energy, and the resource in time and space.
#pragma once

#include <trophic/io/csv_file.hpp>
#include <trophic/population/view.hpp>

namespace trophic::io {

/// energy.csv: one row per species and tick, after that tick's rules. stock_J is the previous row's plus the other columns, minus
/// those from upkeep_J on.
struct EnergyRow {
  double time_s = 0.0;
  std::int64_t tick = 0;
  Species species = 0;
  std::size_t individuals = 0;
  double outside_J = 0.0;
  double field_J = 0.0;
  double victims_J = 0.0;
  double received_J = 0.0;
  double upkeep_J = 0.0;
  double eaten_J = 0.0;
  double given_J = 0.0;
  double lost_J = 0.0;
  double stock_J = 0.0;

  static constexpr auto columns() {
    return std::tuple{column("time_s", &EnergyRow::time_s, "s", "time by the ecology's clock", seconds),
                      column("tick", &EnergyRow::tick, "", "index of the decision step; 0 at the start"),
                      species_column("species", &EnergyRow::species, "the species"),
                      column("individuals", &EnergyRow::individuals, "", "number of living members"),
                      column("outside_J", &EnergyRow::outside_J, "J",
                             "gained by founders and newcomers, which no parent endows, as bonuses for catches, and as grants"),
                      column("field_J", &EnergyRow::field_J, "J", "taken from the resource"),
                      column("victims_J", &EnergyRow::victims_J, "J", "gained from caught victims"),
                      column("received_J", &EnergyRow::received_J, "J", "gained by newborns from their parents"),
                      column("upkeep_J", &EnergyRow::upkeep_J, "J", "spent on living and walking"),
                      column("eaten_J", &EnergyRow::eaten_J, "J", "lost to the hunters that caught members"),
                      column("given_J", &EnergyRow::given_J, "J", "given by parents to newborns"),
                      column("lost_J", &EnergyRow::lost_J, "J", "lost with the dead"),
                      column("stock_J", &EnergyRow::stock_J, "J", "energy of all living members")};
  }
};

/// resource.csv: one row per tick. stock_J is the previous row's plus grown_J minus taken_J.
struct ResourceRow {
  double time_s = 0.0;
  std::int64_t tick = 0;
  double grown_J = 0.0;
  double taken_J = 0.0;
  double stock_J = 0.0;

  static constexpr auto columns() {
    return std::tuple{
        column("time_s", &ResourceRow::time_s, "s", "time by the ecology's clock", seconds),
        column("tick", &ResourceRow::tick, "", "index of the decision step; 0 at the start"),
        column("grown_J", &ResourceRow::grown_J, "J", "grown by the rule Resource; negative if the resource decays"),
        column("taken_J", &ResourceRow::taken_J, "J", "taken by individuals"),
        column("stock_J", &ResourceRow::stock_J, "J", "energy of all cells")};
  }
};

/// field.csv: one row per cell of the resource at every hundredth tick.
struct FieldRow {
  double time_s = 0.0;
  double x_m = 0.0;
  double y_m = 0.0;
  double food_J = 0.0;

  static constexpr auto columns() {
    return std::tuple{column("time_s", &FieldRow::time_s, "s", "time by the ecology's clock", seconds),
                      column("x_m", &FieldRow::x_m, "m", "centre of the cell", micro),
                      column("y_m", &FieldRow::y_m, "m", "centre of the cell", micro),
                      column("food_J", &FieldRow::food_J, "J", "energy in the cell")};
  }
};

/// Writes an EnergyRow per species and tick.
class EnergyLog : public CsvFile<EnergyRow> {
 public:
  using CsvFile::CsvFile;
  static constexpr std::string_view file_name = "energy.csv";

  void on_tick(const View& view) {
    std::vector<double> stock_J(view.energy.size());
    for (const Individual& one : view.robots) {
      if (one.lives()) stock_J[one.species] += one.energy_J;
    }
    for (Species species = 0; species < view.energy.size(); ++species) {
      const EnergyFlow& flow = view.energy[species];
      write({.time_s = view.time_s,
             .tick = view.tick,
             .species = species,
             .individuals = view.count(species),
             .outside_J = flow.outside_J,
             .field_J = flow.field_J,
             .victims_J = flow.victims_J,
             .received_J = flow.received_J,
             .upkeep_J = flow.upkeep_J,
             .eaten_J = flow.eaten_J,
             .given_J = flow.given_J,
             .lost_J = flow.lost_J,
             .stock_J = stock_J[species]},
            view.web);
    }
    flush();
  }
};

/// Writes a ResourceRow per tick.
class ResourceLog : public CsvFile<ResourceRow> {
 public:
  using CsvFile::CsvFile;
  static constexpr std::string_view file_name = "resource.csv";

  void on_tick(const View& view) {
    write({.time_s = view.time_s,
           .tick = view.tick,
           .grown_J = view.resource.grown_J,
           .taken_J = view.resource.taken_J,
           .stock_J = view.field->total_J()});
    flush();
  }
};

/// Writes a FieldRow per cell at every tenth tick, or every hundredth for a field of more than 10,000 cells.
class FieldLog : public CsvFile<FieldRow> {
 public:
  using CsvFile::CsvFile;
  static constexpr std::string_view file_name = "field.csv";

  void on_tick(const View& view) {
    if (view.tick % (view.field->cells() > 10'000 ? 100 : 10) != 0) return;
    for (std::size_t cell = 0; cell < view.field->cells(); ++cell) {
      const GroundPose at = view.field->centre(cell);
      write({.time_s = view.time_s, .x_m = at.x_m, .y_m = at.y_m, .food_J = view.field->food_J(cell)});
    }
    flush();
  }
};

}  // namespace trophic::io
