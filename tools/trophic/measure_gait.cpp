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
  double duration_s = 50.0;
  bool walk = false;
};

/// The physics of the paper and of its released code.
inline constexpr std::array physics{Physics{.timestep_s = 0.0012, .integrator = Integrator::semi_implicit_euler},
                                    Physics{.timestep_s = 0.012, .integrator = Integrator::rk4}};

void complain(const Physics& how, const Diverged& error) {
  std::cerr << "trophic measure-gait: " << enum_name(how.integrator) << " " << how.timestep_s << " s: " << error.what() << "\n";
}

/// Says it if most steps were not those of the fast mode: runs of such a robot are slow.
void remark_speed(const Physics& how, double engine_share) {
  if (engine_share <= 0.5) return;
  std::cerr << "trophic measure-gait: " << enum_name(how.integrator) << " " << how.timestep_s << " s: the engine itself computed "
            << number_text(std::round(100.0 * engine_share))
            << " % of the steps, so fast stepping is as slow as islands with this robot\n";
}

/// The [walk] of a robot file.
/// Returns how many walks could be measured.
std::size_t print_walk(const BackendChoice& backend, const RobotModel& robot, const Gait& gait, double duration_s) {
  std::size_t measured = 0;
  for (const Physics& how : physics) {
    try {
      const MeasuredWalk walk = gait_evolution::measure_walk(robot, gait, control::steering::TargetedSteering{},
                                                             {.duration_s = duration_s}, how, backend, 8);
      std::cout << "# " << robot.name << " with " << gait.name << ", " << backend.name() << ", " << enum_name(how.integrator)
                << " " << how.timestep_s << " s\n[walk]\nspeed_m_s = " << walk.speed_m_s
                << "\nturn_rate_per_rad = " << walk.turn_rate_per_rad << std::endl;
      ++measured;
      if (walk.speed_m_s <= 0.0 || walk.turn_rate_per_rad <= 0.0) {
        std::cerr << "trophic measure-gait: a robot file cannot have these values, because the gait walks backwards or turns the "
                     "wrong way\n";
      }
    } catch (const Diverged& error) {
      complain(how, error);
    }
  }
  return measured;
}

/// A name as a cell, in quotes if it has a comma or a quote.
[[nodiscard]] std::string cell_of(const std::string& name) {
  if (name.find_first_of(",\"") == std::string::npos) return name;
  std::string cell = "\"";
  for (const char c : name) cell += c == '"' ? std::string{"\"\""} : std::string{c};
  return cell + "\"";
}

/// Returns how many walks could be measured.
std::size_t print_table(const BackendChoice& backend, const RobotModel& robot, const Gait& gait, double duration_s) {
  std::size_t measured = 0;
  std::cout << "robot,gait,integrator,timestep_s,target_angle_rad,displacement_m,forward_m_s,left_m_s,turn_rate_rad_s\n";
  for (const Physics& how : physics) {
    double engine_share = 0.0;
    for (const double target_angle_rad : {0.7, 0.0, -0.7}) {
      std::cout << cell_of(robot.name) << "," << cell_of(gait.name) << "," << enum_name(how.integrator) << "," << how.timestep_s
                << "," << target_angle_rad << ",";
      try {
        const gait_evolution::Track track =
            gait_evolution::try_out(robot, gait, control::steering::TargetedSteering{}, {.duration_s = duration_s}, how, backend,
                                    gait_evolution::steady(target_angle_rad));
        const auto [forward_m_s, left_m_s] = track.forward_and_left_m_s();
        std::cout << track.displacement_m() << "," << forward_m_s << "," << left_m_s << "," << track.turn_rate_rad_s()
                  << std::endl;
        ++measured;
        engine_share = std::max(engine_share, track.engine_share);
      } catch (const Diverged& error) {
        std::cout << ",,," << std::endl;
        complain(how, error);
      }
    }
    remark_speed(how, engine_share);
  }
  return measured;
}

int measure(const BackendChoice& backend, const Options& options) {
  const RobotModel robot = load_robot(options.robot);
  if (options.gait.empty() && robot.gait.empty()) {
    throw std::invalid_argument{"--gait: must name a gait, because the file of " + robot.name + " names none"};
  }
  const Gait gait = load_gait(options.gait.empty() ? robot.gait : options.gait);
  check_fit(gait, robot);
  const std::size_t measured =
      options.walk ? print_walk(backend, robot, gait, options.duration_s) : print_table(backend, robot, gait, options.duration_s);
  flush_output();
  if (measured == 0) throw std::runtime_error{"nothing could be measured: every simulation diverged"};
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
  return {.name = "measure-gait",
          .about =
              "Lets a robot walk on an endless floor with target angles of 0.7 (right), 0 and -0.7 rad, under the physics of the "
              "paper and of its released code. Prints the displacement from start to end, the mean speeds along the heading and "
              "to its left over 5 s, and the turning rate (counter-clockwise); the columns are empty if the simulation diverges.",
          .options = {{"--robot", &options->robot, "name or path of a robot file (default: spider)"},
                      {"--gait", &options->gait, "name or path of a gait file (default: the robot's own)"},
                      {"--backend", &options->backend, backend_help(joint_driven_names())},
                      {"--duration", &options->duration_s, "duration in simulated seconds (default: 50)"},
                      {"--walk", &options->walk,
                       "print the [walk] section of a robot file instead: means of 8 trials at 0.7 and 8 at -0.7 rad"}},
          .work = [options] { return detail::measure_gait::run(*options); },
          .subcommands = {},
          .version = {}};
}

}  // namespace trophic::command
