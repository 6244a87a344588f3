// SPDX-License-Identifier: MIT
// The report of a cross-check: lines of one CSV, and text for the terminal.
#pragma once

#include <tools/analysis/statistics/equivalence.hpp>
#include <tools/analysis/statistics/estimate.hpp>
#include <trophic/io/csv_file.hpp>

namespace trophic::command::cross_check {

/// Subject of a line of cross_check.csv. Gaits have settings, timestep and target angle; metrics have species and group.
struct Subject {
  std::string_view part;  ///< gait or ecology
  std::string engine;
  std::string settings;
  std::optional<double> timestep_s;
  std::optional<double> target_angle_rad;
  std::string_view quantity;
  std::string species;
  std::string group;
  std::string_view unit;
};

/// cross_check.csv: a mean over n robots or runs with its 95 % interval, and how it differs from MuJoCo's at its default
/// timestep.
struct CheckRow {
  std::string part = {};
  std::string engine = {};
  std::string settings = {};
  std::optional<double> timestep_s = {};
  std::optional<double> target_angle_rad = {};
  std::string quantity = {};
  std::string species = {};
  std::string group = {};
  std::string unit = {};
  std::optional<double> mean = {};
  std::optional<double> lower = {};
  std::optional<double> upper = {};
  std::size_t n = 0;
  std::optional<double> margin = {};
  std::optional<double> difference = {};
  std::optional<double> difference_lower = {};
  std::optional<double> difference_upper = {};
  std::string conclusion = {};

  static constexpr auto columns() {
    using trophic::io::column;
    return std::tuple{
        column("part", &CheckRow::part, "", "gait or ecology"),
        column("engine", &CheckRow::engine, "", "name of the physics engine"),
        column("settings", &CheckRow::settings, "", "which parameters of the engine; of gaits"),
        column("timestep_s", &CheckRow::timestep_s, "s", "of the engine; of gaits"),
        column("target_angle_rad", &CheckRow::target_angle_rad, "rad", "that the robots were steered by; of gaits"),
        column("quantity", &CheckRow::quantity, "", "what was measured"),
        column("species", &CheckRow::species, "", "of metrics"),
        column("group", &CheckRow::group, "", "of metrics, as in metrics.csv"),
        column("unit", &CheckRow::unit, "", "of mean, margin, difference and intervals"),
        column("mean", &CheckRow::mean, "", "over robots or runs"),
        column("lower", &CheckRow::lower, "", "of its 95 % interval"),
        column("upper", &CheckRow::upper, "", "of its 95 % interval"),
        column("n", &CheckRow::n, "", "robots or runs"),
        column("margin", &CheckRow::margin, "", "within which engines are equivalent"),
        column("difference", &CheckRow::difference, "",
               "of gaits: to MuJoCo's mean at its default timestep; of ecologies: the second set's less the first's"),
        column("difference_lower", &CheckRow::difference_lower, "", "of its 90 % interval"),
        column("difference_upper", &CheckRow::difference_upper, "", "of its 90 % interval"),
        column("conclusion", &CheckRow::conclusion, "", "equivalent, different, inconclusive or unknown")};
  }
};

class Csv {
 public:
  explicit Csv(const std::filesystem::path& path) : file_{path} {}

  /// Mean and 95 % interval over n robots or runs; `against_mujoco`: MuJoCo's at its default timestep are the test's first set.
  void add(const Subject& subject, const analysis::Estimate& estimate,
           const std::optional<analysis::EquivalenceTest>& against_mujoco = {});

 private:
  trophic::io::CsvFile<CheckRow> file_;
};

[[nodiscard]] std::string text(double value, int decimals);

/// "mean [lower, upper]", as much of it as there is.
[[nodiscard]] std::string text(const std::optional<double>& mean, const std::optional<analysis::Interval>& interval, double unit,
                               int decimals);

}  // namespace trophic::command::cross_check
