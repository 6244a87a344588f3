// SPDX-License-Identifier: MIT
// trophic-walks ROBOT...: how robots walk on MuJoCo at paces from 0.2 to 10, as CSV on standard output.
//
// A row is one walk of 180 s, of which the first 10 are left out. Each robot walks with its own gait, alone on an endless floor
// with its own friction, under the physics of the table paper and this gravity, m/s^2: straight ahead, and steered by the two
// outputs of a cognitive brain.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iostream>
#include <string_view>
#include <trophic/backend/mujoco.hpp>
#include <trophic/control/locomotion/locomotion.hpp>
#include <trophic/control/steering/targeted_steering.hpp>
#include <trophic/habitat/ground_pose.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/habitat/touch.hpp>

extern "C" const char* trophic_revision;  ///< of trophic's sources, by its own build

namespace {

using namespace trophic;

constexpr std::array paces{0.2, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0, 8.0, 10.0};
constexpr std::size_t places = 10;
constexpr double control_hz = 60.0;
constexpr std::size_t gentle_steps = 120;  ///< in which targets grow from 0, as their jump at the start can turn a robot over
constexpr std::size_t first_step = 600;    ///< of the control steps that are measured
constexpr std::size_t window_steps = 300;  ///< in which the speed along the mean heading is measured
constexpr double contact_m = 0.002;        ///< a corner lower than this touches the floor
constexpr double brain_angle_rad = 0.7;

/// MuJoCo, and the targets that its servos have now.
struct Bodies {
  const RobotModel& robot;
  backend::Mujoco& engine;
  std::vector<std::vector<double>>& targets_rad;
  double share = 0.0;  ///< of the gait's targets
  void set_joint_targets(std::size_t place, std::span<const double> targets) {
    targets_rad[place].resize(targets.size());
    for (std::size_t hinge = 0; hinge < targets.size(); ++hinge) {
      const double limit = robot.hinges[hinge].servo.target_limit_rad;
      targets_rad[place][hinge] = share * std::clamp(targets[hinge], -limit, limit);
    }
    engine.set_joint_targets(place, targets_rad[place]);
  }
  void advance_to(double time_s) { engine.advance_to(time_s); }
};

[[nodiscard]] std::vector<Eigen::Vector3d> corners_of(const RobotModel& robot, const Pose& root,
                                                      std::span<const double> angles_rad) {
  std::vector<Eigen::Vector3d> corners;
  for (const PlacedBox& box : placed_boxes(robot, root, angles_rad)) {
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0})
        for (const double z : {-1.0, 1.0}) corners.emplace_back(box.centre_m + box.half_edges_m * Eigen::Vector3d{x, y, z});
  }
  return corners;
}

/// One walk, measured after each control step.
class Walk {
 public:
  void add(const RobotModel& robot, const Pose& root, std::span<const double> angles_rad, std::span<const double> targets_rad) {
    poses_.push_back(ground_pose(root, robot.forward_rad));
    if ((root.orientation * Eigen::Vector3d::UnitZ()).z() < 0.0) ++overturned_;
    for (std::size_t hinge = 0; hinge < angles_rad.size(); ++hinge) {
      squares_of_errors_ += std::pow(angles_rad[hinge] - targets_rad[hinge], 2);
      squares_of_angles_ += std::pow(angles_rad[hinge], 2);
      squares_of_targets_ += std::pow(targets_rad[hinge], 2);
    }
    hinges_ = angles_rad.size();
    add_corners(corners_of(robot, root, angles_rad));
  }

  /// Mean speed along the heading: the path in each window, seen along the mean heading in it.
  [[nodiscard]] double speed_m_s() const {
    double ahead_m = 0.0;
    for (std::size_t first = 0; first + window_steps < poses_.size(); ++first) {
      double x = 0.0, y = 0.0;
      for (std::size_t i = first; i <= first + window_steps; ++i) {
        x += std::cos(poses_[i].heading_rad);
        y += std::sin(poses_[i].heading_rad);
      }
      const GroundPose &start = poses_[first], &end = poses_[first + window_steps];
      ahead_m += ((end.x_m - start.x_m) * x + (end.y_m - start.y_m) * y) / std::hypot(x, y);
    }
    return ahead_m * control_hz / static_cast<double>((poses_.size() - window_steps) * window_steps);
  }
  /// Root mean square of target - angle at the end of a control step.
  [[nodiscard]] double error_rad() const { return std::sqrt(squares_of_errors_ / static_cast<double>(hinges_ * poses_.size())); }
  /// Root mean square of the angles, as a share of that of the targets.
  [[nodiscard]] double swing() const { return std::sqrt(squares_of_angles_ / squares_of_targets_); }
  /// Mean speed over the floor of the corners that touch it.
  [[nodiscard]] double slip_m_s() const { return touching_ == 0 ? 0.0 : slid_m_ * control_hz / static_cast<double>(touching_); }
  /// Share of the control steps in which no corner touches the floor.
  [[nodiscard]] double airborne() const { return static_cast<double>(airborne_) / static_cast<double>(poses_.size() - 1); }
  /// Share of the control steps in which the core's upper side points down.
  [[nodiscard]] double overturned() const { return static_cast<double>(overturned_) / static_cast<double>(poses_.size()); }

 private:
  /// A corner slides as far as it moves over the floor in a control step before and after which it touches the floor.
  void add_corners(std::vector<Eigen::Vector3d> corners_m) {
    const std::size_t before = touching_;
    for (std::size_t i = 0; i < corners_m_.size(); ++i) {
      if (corners_m_[i].z() > contact_m || corners_m[i].z() > contact_m) continue;
      slid_m_ += (corners_m[i] - corners_m_[i]).head<2>().norm();
      ++touching_;
    }
    if (!corners_m_.empty() && touching_ == before) ++airborne_;
    corners_m_ = std::move(corners_m);
  }

  std::vector<GroundPose> poses_;
  std::vector<Eigen::Vector3d> corners_m_;
  double squares_of_errors_ = 0.0, squares_of_angles_ = 0.0, squares_of_targets_ = 0.0, slid_m_ = 0.0;
  std::size_t hinges_ = 0, touching_ = 0, airborne_ = 0, overturned_ = 0;
};

/// The walks of a robot from all places. They begin up to 1 mm above the floor, as contacts make walking chaotic.
[[nodiscard]] std::vector<Walk> walks_of(const RobotModel& robot, double pace, std::span<const double> turns_rad,
                                         double duration_s, const Physics& physics) {
  const Arena floor{
      .name = "endless_floor", .half_side_m = 1000.0, .extent_m = 2000.0, .friction = robot.friction, .height_field = {}};
  std::vector<Pose> starts;
  for (std::size_t place = 0; place < places; ++place) {
    const auto number = static_cast<double>(place);
    starts.push_back({.position_m = {100.0 * number - 450.0, 0.0, robot.rest_height_m + 0.001 * number / places},
                      .orientation = Eigen::Quaterniond::Identity()});
  }
  backend::Mujoco engine{robot, floor, starts, physics, {}};
  std::vector<std::vector<double>> targets_rad(places);
  Bodies bodies{robot, engine, targets_rad};
  locomotion::Locomotion locomotion{
      robot, load_gait(robot.gait), control::steering::TargetedSteering{}, places, {.hz = control_hz}};
  locomotion.set_paces(std::vector<double>(places, pace));
  std::vector<Walk> walks(places);
  const std::size_t last_step = first_step + static_cast<std::size_t>(std::llround(duration_s * control_hz));
  for (std::size_t step = 1; step <= last_step; ++step) {
    bodies.share = std::min(1.0, static_cast<double>(step) / gentle_steps);
    locomotion.advance(bodies, 1, turns_rad);
    if (step < first_step) continue;
    for (std::size_t place = 0; place < places; ++place)
      walks[place].add(robot, engine.pose(place), engine.joint_angles(place), targets_rad[place]);
  }
  return walks;
}

void print(const RobotModel& robot, double pace, bool is_steered, double duration_s, const Physics& physics) {
  std::array<double, places> turns_rad{};
  for (std::size_t place = 0; place < places && is_steered; ++place)
    turns_rad[place] = place % 2 == 0 ? brain_angle_rad : -brain_angle_rad;
  const std::vector<Walk> walks = walks_of(robot, pace, turns_rad, duration_s, physics);
  for (std::size_t place = 0; place < places; ++place) {
    const Walk& walk = walks[place];
    std::cout << robot.name << ',' << pace << ',' << turns_rad[place] << ',' << place << ',' << walk.speed_m_s() << ','
              << walk.error_rad() << ',' << walk.swing() << ',' << walk.slip_m_s() << ',' << walk.airborne() << ','
              << walk.overturned() << ",MuJoCo " << backend::Mujoco::version() << ',' << trophic_revision << std::endl;
  }
}

[[nodiscard]] double number_of(const std::string& name, std::string_view text, double least, double most) {
  double number = 0.0;
  const auto [end, failed] = std::from_chars(text.begin(), text.end(), number);
  if (failed == std::errc{} && end == text.end() && number >= least && number <= most) return number;
  throw std::invalid_argument{name + " = " + std::string{text} + ": must be >= " + number_text(least) +
                              " and <= " + number_text(most)};
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 4) throw std::invalid_argument{"usage: trophic-walks SECONDS GRAVITY ROBOT..."};
    const double duration_s = number_of("SECONDS", argv[1], 10.0, 1e5);
    const Physics physics{.gravity_m_s2 = number_of("GRAVITY", argv[2], 0.1, 1000.0)};
    std::vector<RobotModel> robots;
    for (int i = 3; i < argc; ++i) robots.push_back(load_robot(argv[i]));
    std::cout << "robot,pace,target_angle_rad,place,speed_m_s,error_rad,swing,slip_m_s,airborne,overturned,engine,revision\n";
    for (const RobotModel& robot : robots)
      for (const bool is_steered : {false, true})
        for (const double pace : paces) print(robot, pace, is_steered, duration_s, physics);
  } catch (const std::exception& error) {
    std::cerr << "trophic-walks: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
