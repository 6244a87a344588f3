// SPDX-License-Identifier: MIT
// `trophic measure-gait`, how a gait walks and steers: a CSV table on standard output.
#include "commands.hpp"

#include <algorithm>
#include <cmath>
#include <tools/command/backends.hpp>
#include <tools/command/option.hpp>
#include <tools/command/output.hpp>
#include <tools/gait_evolution/trial.hpp>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/control/steering/targeted_steering.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/robot.hpp>

namespace trophic::command {

namespace detail::measure_gait {

struct Options {
  std::string backend{default_backend};
  std::string robot = "spider";
  std::string gait;
  std::string table = "paper";
  double duration_s = 50.0;
  bool walk = false;
};

/// What is measured, and on what.
struct Measured {
  const BackendChoice& backend;
  const RobotModel& robot;
  const Gait& gait;
  Physics physics;
  double duration_s;

  /// "tripod with tripod, mujoco, rk4 0.012 s".
  [[nodiscard]] std::string text() const {
    return robot.name + " with " + gait.name + ", " + backend.name() + ", " + std::string{enum_name(physics.integrator)} + " " +
           number_text(physics.timestep_s) + " s";
  }
};

/// The physics of a rule table, the paper's or the released code's.
[[nodiscard]] Physics physics_of(const std::string& table) {
  if (table == "released") return {.timestep_s = 0.012, .integrator = Integrator::rk4};
  return {.timestep_s = 0.0012, .integrator = Integrator::semi_implicit_euler};
}

void remark(const std::string& what) {
  std::cerr << "trophic measure-gait: " << what << "\n";
}

/// Prints it if most steps were not those of the fast mode: runs of such a robot are slow.
void remark_speed(double engine_share) {
  if (engine_share <= 0.5) return;
  remark("the engine itself computed " + number_text(std::round(100.0 * engine_share)) +
         " % of the steps, so fast stepping is as slow as islands with this robot");
}

/// Prints it if a robot does not walk ahead, so that targeted steering cannot bring it anywhere.
void remark_walk(double forward_m_s, double left_m_s) {
  if (forward_m_s <= 0.0)
    remark("the robot walks backwards; evolve-gait --fitness steered_displacement asks for a gait that walks ahead");
  else if (forward_m_s < std::abs(left_m_s))
    remark("the robot walks more to its side than ahead; forward_deg of its file is the direction that counts as ahead");
}

/// The [walk] of a robot file.
void print_walk(const Measured& of) {
  const MeasuredWalk walk = gait_evolution::measure_walk(of.robot, of.gait, control::steering::TargetedSteering{},
                                                         {.duration_s = of.duration_s}, of.physics, of.backend, 8);
  std::cout << "# " << of.text() << "\n[walk]\nspeed_m_s = " << walk.speed_m_s
            << "\nturn_rate_per_rad = " << walk.turn_rate_per_rad << std::endl;
  remark_walk(walk.speed_m_s, 0.0);
  if (walk.turn_rate_per_rad <= 0.0) remark("the robot turns the wrong way; the kinematic backend needs a rate above 0");
}

/// A name as a cell, in quotes if it has a comma or a quote.
[[nodiscard]] std::string cell_of(const std::string& name) {
  if (name.find_first_of(",\"") == std::string::npos) return name;
  std::string cell = "\"";
  for (const char c : name) cell += c == '"' ? std::string{"\"\""} : std::string{c};
  return cell + "\"";
}

void print_table(const Measured& of) {
  double engine_share = 0.0;
  double forward_m_s = 0.0;
  double left_m_s = 0.0;
  std::cout << "robot,gait,integrator,timestep_s,target_angle_rad,displacement_m,forward_m_s,left_m_s,turn_rate_rad_s\n";
  for (const double target_angle_rad : {0.7, 0.0, -0.7}) {
    const gait_evolution::Track track =
        gait_evolution::try_out(of.robot, of.gait, control::steering::TargetedSteering{}, {.duration_s = of.duration_s},
                                of.physics, of.backend, gait_evolution::steady(target_angle_rad));
    const auto [forward, left] = track.forward_and_left_m_s();
    std::cout << cell_of(of.robot.name) << "," << cell_of(of.gait.name) << "," << enum_name(of.physics.integrator) << ","
              << of.physics.timestep_s << "," << target_angle_rad << "," << track.displacement_m() << "," << forward << ","
              << left << "," << track.turn_rate_rad_s() << std::endl;
    engine_share = std::max(engine_share, track.engine_share);
    forward_m_s += forward / 3.0;
    left_m_s += left / 3.0;
  }
  remark_speed(engine_share);
  remark_walk(forward_m_s, left_m_s);
}

int measure(const BackendChoice& backend, const Options& options) {
  const RobotModel robot = load_robot(options.robot);
  if (options.gait.empty() && robot.gait.empty()) {
    throw std::invalid_argument{"--gait: must name a gait, because the file of " + robot.name + " names none"};
  }
  const Gait gait = load_gait(options.gait.empty() ? robot.gait : options.gait);
  check_fit(gait, robot);
  const Measured of{backend, robot, gait, physics_of(options.table), options.duration_s};
  try {
    options.walk ? print_walk(of) : print_table(of);
  } catch (const Diverged& error) {
    throw std::runtime_error{of.text() + ": " + error.what()};
  }
  flush_output();
  return 0;
}

[[nodiscard]] int run(const Options& options) {
  if (!(options.duration_s >= 5.1 && options.duration_s <= 1e5)) {
    throw std::invalid_argument{"--duration " + number_text(options.duration_s) + ": must be >= 5.1 and <= 100000"};
  }
  return measure(joint_driven_backend(options.backend), options);
}

}  // namespace detail::measure_gait

/// Walks of a robot with a gait, on a backend with joints.
Command measure_gait() {
  const auto options = std::make_shared<detail::measure_gait::Options>();
  return {
      .name = "measure-gait",
      .about =
          "Lets a robot walk on an endless floor with target angles of 0.7 (right), 0 and -0.7 rad. Prints the displacement from "
          "start to end, the mean speeds along the heading and to its left over 5 s, and the turning rate (counter-clockwise). A "
          "simulation that diverges is an error, and a robot that does not walk ahead gets a remark.",
      .options = {{"--robot", &options->robot, "name or path of a robot file (default: spider)"},
                  {"--gait", &options->gait, "name or path of a gait file (default: the robot's own)"},
                  {"--backend", &options->backend, backend_help(joint_driven_names())},
                  {.name = "--table",
                   .target = &options->table,
                   .help = "physics of the rule table paper or released (default: paper)",
                   .words = {"paper", "released"}},
                  {"--duration", &options->duration_s, "duration in simulated seconds (default: 50)"},
                  {"--walk", &options->walk,
                   "print the [walk] section of a robot file instead: means of 8 trials at 0.7 and 8 at -0.7 rad"}},
      .work = [options] { return detail::measure_gait::run(*options); },
      .subcommands = {},
      .version = {}};
}

}  // namespace trophic::command
