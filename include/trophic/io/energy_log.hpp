// SPDX-License-Identifier: MIT
// energy.csv, resource.csv and field.csv: the ledger of energy, and the resource in time and space.
#pragma once

#include <trophic/io/csv_file.hpp>
#include <trophic/population/view.hpp>

namespace trophic::io {

namespace detail {

inline constexpr std::string_view food_help = "the food; only in a table of several";
inline constexpr Written if_named{.if_any = true};

/// The name of a food in a row.
[[nodiscard]] inline std::optional<std::string_view> food_name(const View& view, std::size_t food) {
  return view.food_names.empty() ? std::nullopt : std::optional{view.food_names[food]};
}

}  // namespace detail

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

/// resource.csv: one row per food and tick. stock_J is the food's previous row's plus grown_J minus taken_J and destroyed_J.
struct ResourceRow {
  double time_s = 0.0;
  std::int64_t tick = 0;
  std::optional<std::string_view> food = {};
  double grown_J = 0.0;
  double taken_J = 0.0;
  double destroyed_J = 0.0;
  double stock_J = 0.0;

  static constexpr auto columns() {
    return std::tuple{column("time_s", &ResourceRow::time_s, "s", "time by the ecology's clock", seconds),
                      column("tick", &ResourceRow::tick, "", "index of the decision step; 0 at the start"),
                      column("food", &ResourceRow::food, "", detail::food_help, detail::if_named),
                      column("grown_J", &ResourceRow::grown_J, "J", "grown by the rule Resource"),
                      column("taken_J", &ResourceRow::taken_J, "J", "eaten by individuals"),
                      column("destroyed_J", &ResourceRow::destroyed_J, "J",
                             "destroyed by eaters and by the rule Resource, such as the rest of a bitten patch"),
                      column("stock_J", &ResourceRow::stock_J, "J", "energy of all cells")};
  }
};

/// field.csv: one row per cell of each food at every tenth tick.
struct FieldRow {
  double time_s = 0.0;
  std::optional<std::string_view> food = {};
  double x_m = 0.0;
  double y_m = 0.0;
  double food_J = 0.0;

  static constexpr auto columns() {
    return std::tuple{column("time_s", &FieldRow::time_s, "s", "time by the ecology's clock", seconds),
                      column("food", &FieldRow::food, "", detail::food_help, detail::if_named),
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

/// Writes a ResourceRow per food and tick.
class ResourceLog : public CsvFile<ResourceRow> {
 public:
  static constexpr std::string_view file_name = "resource.csv";

  explicit ResourceLog(const std::filesystem::path& path, Opening opening = Opening::created)
      : CsvFile{path, std::nullopt, opening} {}

  void on_tick(const View& view) {
    begin({.food = detail::food_name(view, 0)});
    for (std::size_t food = 0; food < view.foods.size(); ++food) {
      const ResourceFlow& flow = view.resource[food];
      write({.time_s = view.time_s,
             .tick = view.tick,
             .food = detail::food_name(view, food),
             .grown_J = flow.grown_J,
             .taken_J = flow.taken_J,
             .destroyed_J = flow.destroyed_J,
             .stock_J = view.foods[food].total_J()});
    }
    flush();
  }
};

/// Writes a FieldRow per cell of each food at every tenth tick, or every hundredth for foods of more than 10,000 cells in all.
class FieldLog : public CsvFile<FieldRow> {
 public:
  static constexpr std::string_view file_name = "field.csv";

  explicit FieldLog(const std::filesystem::path& path, Opening opening = Opening::created)
      : CsvFile{path, std::nullopt, opening} {}

  void on_tick(const View& view) {
    begin({.food = detail::food_name(view, 0)});
    std::size_t cells = 0;
    for (const ResourceField& food : view.foods) cells += food.cells();
    if (view.tick % (cells > 10'000 ? 100 : 10) != 0) return;
    for (std::size_t food = 0; food < view.foods.size(); ++food) {
      const ResourceField& field = view.foods[food];
      for (std::size_t cell = 0; cell < field.cells(); ++cell) {
        const GroundPose at = field.centre(cell);
        write({.time_s = view.time_s,
               .food = detail::food_name(view, food),
               .x_m = at.x_m,
               .y_m = at.y_m,
               .food_J = field.food_J(cell)});
      }
    }
    flush();
  }
};

}  // namespace trophic::io
