// SPDX-License-Identifier: MIT
// What was compared, as lines of one CSV and as text for the terminal.
#pragma once

#include <filesystem>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <trophic/analysis/report/summary.hpp>
#include <trophic/analysis/statistics/equivalence.hpp>
#include <trophic/observe/csv.hpp>

namespace trophic::command::cross_check {

/// What a line of cross_check.csv is about. Gaits have settings, timestep and target angle; metrics have species and group.
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

class Csv {
 public:
  explicit Csv(const std::filesystem::path& path)
      : file_{path,
              "part,engine,settings,timestep_s,target_angle_rad,quantity,species,group,unit,mean,lower,upper,n,margin,difference,"
              "difference_lower,difference_upper,verdict"} {}

  /// Mean and 95 % interval over n robots or runs; `against_mujoco`: MuJoCo's at its default timestep are the test's first set.
  void add(const Subject& subject, const analysis::Estimate& estimate,
           const std::optional<analysis::EquivalenceTest>& against_mujoco = {}) {
    const auto lower = [](const auto& interval) { return interval ? std::optional{interval->lower} : std::nullopt; };
    const auto upper = [](const auto& interval) { return interval ? std::optional{interval->upper} : std::nullopt; };
    const auto test = against_mujoco.value_or(analysis::EquivalenceTest{});
    file_.row(subject.part, subject.engine, subject.settings, subject.timestep_s, subject.target_angle_rad, subject.quantity,
              subject.species, subject.group, subject.unit, estimate.mean, lower(estimate.interval), upper(estimate.interval),
              estimate.runs, against_mujoco ? std::optional{test.margin} : std::nullopt, test.difference, lower(test.interval),
              upper(test.interval), against_mujoco ? enum_name(test.verdict) : std::string_view{});
    file_.flush();
  }

 private:
  observe::CsvFile file_;
};

[[nodiscard]] inline std::string text(double value, int decimals) {
  std::ostringstream stream;
  stream << std::fixed << std::setprecision(decimals) << value;
  return stream.str();
}

/// "mean [lower, upper]", as much of it as there is.
[[nodiscard]] inline std::string text(const std::optional<double>& mean, const std::optional<analysis::Interval>& interval,
                                      double unit, int decimals) {
  std::string all = mean ? text(unit * *mean, decimals) : "none";
  if (interval) all += " [" + text(unit * interval->lower, decimals) + ", " + text(unit * interval->upper, decimals) + "]";
  return all;
}

}  // namespace trophic::command::cross_check
