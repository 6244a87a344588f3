// SPDX-License-Identifier: MIT
// Definitions of report.hpp.
#include <tools/trophic/cross_check/report.hpp>

#include <iomanip>
#include <sstream>

namespace trophic::command::cross_check {

void Csv::add(const Subject& subject, const analysis::Estimate& estimate,
              const std::optional<analysis::EquivalenceTest>& against_mujoco) {
  const auto lower = [](const auto& interval) { return interval ? std::optional{interval->lower} : std::nullopt; };
  const auto upper = [](const auto& interval) { return interval ? std::optional{interval->upper} : std::nullopt; };
  const auto test = against_mujoco.value_or(trophic::analysis::EquivalenceTest{});
  file_.write({.part = std::string{subject.part},
               .engine = subject.engine,
               .settings = subject.settings,
               .timestep_s = subject.timestep_s,
               .target_angle_rad = subject.target_angle_rad,
               .quantity = std::string{subject.quantity},
               .species = subject.species,
               .group = subject.group,
               .unit = std::string{subject.unit},
               .mean = estimate.mean,
               .lower = lower(estimate.interval),
               .upper = upper(estimate.interval),
               .n = estimate.runs,
               .margin = against_mujoco ? std::optional{test.margin} : std::nullopt,
               .difference = test.difference,
               .difference_lower = lower(test.interval),
               .difference_upper = upper(test.interval),
               .conclusion = std::string{against_mujoco ? trophic::enum_name(test.conclusion) : ""}});
  file_.flush();
}

std::string text(double value, int decimals) {
  std::ostringstream stream;
  stream << std::fixed << std::setprecision(decimals) << value;
  return stream.str();
}

std::string text(const std::optional<double>& mean, const std::optional<analysis::Interval>& interval, double unit,
                 int decimals) {
  std::string all = mean ? text(unit * *mean, decimals) : "none";
  if (interval) all += " [" + text(unit * interval->lower, decimals) + ", " + text(unit * interval->upper, decimals) + "]";
  return all;
}

}  // namespace trophic::command::cross_check
