// SPDX-License-Identifier: MIT
// How a gait walks and steers: a CSV table on standard output. `measure_gait --help` lists the options.
#include <CLI/CLI.hpp>
#include <iostream>
#include <stdexcept>
#include <string>
#include <trophic/backend/mujoco.hpp>
#include <trophic/gait_evolution/measure_walk.hpp>
#include <trophic/gait_evolution/trial.hpp>
#include <trophic/load/gait.hpp>
#include <trophic/load/robot.hpp>
#include <trophic/params/params.hpp>
#include <vector>

#include "command.hpp"

namespace {

namespace gait_evolution = trophic::gait_evolution;
using Backend = trophic::backend::Mujoco;

/// Of the paper and of its released code.
const std::vector<trophic::Physics> physics{{.timestep_s = 0.0012, .integrator = trophic::Integrator::semi_implicit_euler},
                                            {.timestep_s = 0.012, .integrator = trophic::Integrator::rk4}};

void complain(const trophic::Physics& how, const trophic::Diverged& error) {
  std::cerr << "measure_gait: " << enum_name(how.integrator) << " " << how.timestep_s << " s: " << error.what() << "\n";
}

/// The [walk] of a robot file.
void print_walk(const trophic::RobotModel& robot, const trophic::Gait& gait, double duration_s) {
  for (const trophic::Physics& how : physics) {
    try {
      const trophic::MeasuredWalk walk = gait_evolution::measure_walk<Backend>(
          robot, gait, trophic::control::steering::TargetedSteering{}, {.duration_s = duration_s}, how, {}, 8);
      std::cout << "# " << robot.name << " with " << gait.name << ", MuJoCo, " << enum_name(how.integrator) << " "
                << how.timestep_s << " s\n[walk]\nspeed_m_s = " << walk.speed_m_s
                << "\nturn_rate_per_rad = " << walk.turn_rate_per_rad << std::endl;
    } catch (const trophic::Diverged& error) {
      complain(how, error);
    }
  }
}

void print_table(const trophic::RobotModel& robot, const trophic::Gait& gait, double duration_s) {
  std::cout << "robot,gait,integrator,timestep_s,target_angle_rad,displacement_m,forward_m_s,left_m_s,turn_rate_rad_s\n";
  for (const trophic::Physics& how : physics) {
    for (const double target_angle_rad : {0.7, 0.0, -0.7}) {
      std::cout << robot.name << "," << gait.name << "," << enum_name(how.integrator) << "," << how.timestep_s << ","
                << target_angle_rad << ",";
      try {
        const gait_evolution::Track track =
            gait_evolution::try_out<Backend>(robot, gait, trophic::control::steering::TargetedSteering{},
                                             {.duration_s = duration_s}, how, {}, gait_evolution::steady(target_angle_rad));
        const auto [forward_m_s, left_m_s] = track.forward_and_left_m_s();
        std::cout << track.displacement_m() << "," << forward_m_s << "," << left_m_s << "," << track.turn_rate_rad_s()
                  << std::endl;
      } catch (const trophic::Diverged& error) {
        std::cout << ",,," << std::endl;
        complain(how, error);
      }
    }
  }
}

void measure(const std::string& robot_name, const std::string& gait_name, double duration_s, bool walk) {
  const trophic::RobotModel robot = trophic::load_robot(robot_name);
  const trophic::Gait gait = trophic::load_gait(gait_name.empty() ? robot.gait : gait_name);
  trophic::check_fit(gait, robot);
  (walk ? print_walk : print_table)(robot, gait, duration_s);
  if (!std::cout) throw std::runtime_error{"cannot write to standard output"};
}

}  // namespace

int main(int argc, char** argv) {
  using namespace trophic::examples;
  std::string robot = "spider";
  std::string gait;
  double duration_s = 50.0;
  bool walk = false;
  CLI::App app{
      "Lets a robot walk on an endless floor with the target angles 0.7 (right), 0 and -0.7 rad, with the physics of the paper "
      "and of its released code: displacement from start to end, mean speed along the heading and to its left over 5 s, turning "
      "rate "
      "(counter-clockwise); nothing where the simulation diverges."};
  app.add_option("--robot", robot, "name or path of a robot file (spider)");
  app.add_option("--gait", gait, "name or path of a gait file (the robot's own)");
  app.add_option("--duration", duration_s, "simulated seconds (50)")->check(CLI::Range(5.1, 1e5));
  app.add_flag("--walk", walk, "print the [walk] of a robot file instead: means of 8 tries with 0.7 and 8 with -0.7 rad");
  return run_command(app, argc, argv, "measure_gait", [&] {
    measure(robot, gait, duration_s, walk);
    return 0;
  });
}
