// SPDX-License-Identifier: MIT
// Footage written by hand: robots that walk along x by 0.1 m a second, a tick of 2 s after the other.
#pragma once

#include <cstdint>
#include <support/hand_population.hpp>
#include <trophic/habitat/pose.hpp>
#include <trophic/pictures/watch/live_footage.hpp>
#include <vector>

namespace trophic::test {

class WrittenFootage {
 public:
  explicit WrittenFootage(const std::vector<Robot>& robots) : population{robots} {
    model.bounding_radius_m = 0.3;
    start_x_m.reserve(robots.size());
    for (const Robot& robot : robots) start_x_m.push_back(robot.x_m);
    watch::LiveFootage& begun = footage;
    observe::RunDescription run;
    run.tags = {-1, 1};
    run.until_s = 1000.0;
    begun.start(run, population.view());
    add_frame(0.0);
    begun.add_tick(population.view());
  }

  /// Four frames, then the tick.
  void advance() {
    const double from_s = population.time_s;
    for (int i = 1; i <= 4; ++i) add_frame(from_s + 0.5 * i);
    population.at_tick(population.tick + 1);
    for (std::size_t i = 0; i < population.poses.size(); ++i) population.poses[i].x_m = x_m(i, population.time_s);
    footage.add_tick(population.view());
  }

  [[nodiscard]] double x_m(std::size_t body, double time_s) const { return start_x_m[body] + 0.1 * time_s; }

  HandPopulation population;
  RobotModel model;
  std::vector<double> start_x_m;
  watch::LiveFootage footage;

 private:
  void add_frame(double time_s) {
    std::vector<Pose> roots;
    std::vector<double> angles_rad;
    for (std::size_t i = 0; i < population.poses.size(); ++i) {
      roots.push_back(
          {.position_m = {x_m(i, time_s), population.poses[i].y_m, 0.1}, .orientation = Eigen::Quaterniond::Identity()});
      angles_rad.insert(angles_rad.end(), {time_s, -time_s});
    }
    footage.add_frame({.time_s = time_s,
                       .times = {},
                       .roots = roots,
                       .joint_angles_rad = angles_rad,
                       .robot = model,
                       .arena = population.arena});
  }
};

}  // namespace trophic::test
