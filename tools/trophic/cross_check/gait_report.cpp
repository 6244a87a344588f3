// SPDX-License-Identifier: MIT
// Definitions of gait_report.hpp.
#include <tools/trophic/cross_check/gait_report.hpp>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <tools/analysis/statistics/equivalence.hpp>
#include <tools/analysis/statistics/estimate.hpp>

namespace trophic::command::cross_check {

std::vector<double> values_of(const Outcome& outcome, const Quantity& quantity) {
  std::vector<double> values;
  for (const Walk& walk : outcome.walks) values.push_back(walk.*(quantity.value));
  return values;
}

std::vector<double> distances_m(const Outcome& a, const Outcome& b) {
  constexpr std::size_t sample = 5;
  std::vector<double> distances;
  for (std::size_t i = 0; i < a.walks.size(); ++i) {
    distances.push_back(distance_m(a.walks[i].path[sample], b.walks[i].path[sample]));
  }
  return distances;
}

const Outcome& finest(std::span<const Outcome> outcomes, std::string_view engine) {
  const Outcome* best = nullptr;
  for (const Outcome& outcome : outcomes) {
    if (outcome.condition.engine != engine || outcome.condition.settings != default_settings) continue;
    if (best == nullptr || outcome.condition.timestep_s < best->condition.timestep_s) best = &outcome;
  }
  return *best;
}

GaitReport::GaitReport(const std::filesystem::path& folder, Csv& csv) : csv_{csv}, paths_{folder / "trajectories.csv"} {
  std::cout << std::left
            << "one gait: mean over robots [95 %]; difference to mujoco in % of its value at target angle 0.7, with "
               "conclusion for a margin of 10 %;\ndistance after 10 s to the same robot at mujoco's and at the engine's "
               "own finest step\n"
            << std::setw(7) << "engine" << std::setw(13) << "settings" << std::setw(8) << "step ms" << std::setw(6) << "angle"
            << std::setw(22) << "speed cm/s" << std::setw(23) << "turning rad/min" << std::setw(9) << "power W" << std::setw(10)
            << "torque Nm" << std::setw(9) << "off cm" << std::setw(9) << "own cm" << std::setw(20) << "speed differs"
            << "turning differs\n";
}

void GaitReport::add(std::span<const Outcome> outcomes) {
  const Outcome& reference = outcomes.front();
  if (scales_.empty()) {
    for (const Quantity& quantity : quantities) {
      scales_.push_back(std::max(std::abs(*analysis::mean_of(values_of(reference, quantity))), smallest_scale));
    }
  }
  for (const Outcome& outcome : outcomes) {
    add(outcome, reference, finest(outcomes, "mujoco"), finest(outcomes, outcome.condition.engine));
  }
}

void GaitReport::add(const Outcome& outcome, const Outcome& reference, const Outcome& mujoco, const Outcome& own) {
  const Condition& c = outcome.condition;
  std::cout << std::setw(7) << c.engine << std::setw(13) << c.settings << std::setw(8) << text(1e3 * c.timestep_s, 1)
            << std::setw(6) << text(c.target_angle_rad, 1);
  const auto subject = [&](std::string_view quantity, std::string_view unit) {
    return Subject{"gait", c.engine, c.settings, c.timestep_s, c.target_angle_rad, quantity, {}, {}, unit};
  };
  std::string differences;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const Quantity& quantity = quantities[i];
    const auto values = values_of(outcome, quantity);
    const auto estimate = analysis::estimate(values);
    const auto test = analysis::test_equivalence(values_of(reference, quantity), values, margin_share * scales_[i]);
    csv_.add(subject(quantity.name, quantity.unit), estimate, test);
    const bool is_judged = quantity.columns > 20;
    std::cout << std::setw(quantity.columns)
              << text(estimate.mean, is_judged ? estimate.interval : std::nullopt, quantity.shown_unit, is_judged ? 2 : 4);
    if (!is_judged || c.engine == reference.condition.engine) continue;
    std::ostringstream cell;
    cell << std::left << std::setw(20)
         << text(100.0 * *test.difference / scales_[i], 1) + " % " + std::string{enum_name(test.conclusion)};
    differences += cell.str();
  }
  for (const auto& [name, other] : {std::pair{"distance_to_mujoco_m", &mujoco}, std::pair{"distance_to_own_m", &own}}) {
    const auto estimate = analysis::estimate(distances_m(outcome, *other));
    csv_.add(subject(name, "m"), estimate);
    std::cout << std::setw(9) << text(100.0 * *estimate.mean, 2);
  }
  std::cout << differences << std::endl;
  for (std::size_t robot = 0; robot < outcome.walks.size(); ++robot) {
    const auto& path = outcome.walks[robot].path;
    for (std::size_t i = 0; i < path.size(); ++i) {
      paths_.write({.engine = c.engine,
                    .settings = c.settings,
                    .timestep_s = c.timestep_s,
                    .target_angle_rad = c.target_angle_rad,
                    .robot = robot,
                    .time_s = sample_s * static_cast<double>(i),
                    .x_m = path[i].x_m,
                    .y_m = path[i].y_m,
                    .heading_rad = path[i].heading_rad});
    }
  }
  paths_.flush();
}

}  // namespace trophic::command::cross_check
