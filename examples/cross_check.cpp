// SPDX-License-Identifier: MIT
// What depends on the engine: one gait in MuJoCo and ODE at several timesteps and settings, and the metrics of the paper's rules
// on both. `cross_check --help` lists the options.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <trophic/backend/mujoco.hpp>
#include <trophic/backend/ode.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/observe/run_folder.hpp>
#include <trophic/replicates/parallel.hpp>
#include <trophic/replicates/run.hpp>
#include <trophic/rules/paper.hpp>
#include <utility>
#include <vector>

#include "cross_check/ecology.hpp"
#include "cross_check/gait.hpp"
#include "cross_check/gait_report.hpp"
#include "cross_check/report.hpp"

#include "command.hpp"
#include "facts.hpp"

namespace {

using cross_check::Condition;
using trophic::backend::Mujoco;
using trophic::backend::Ode;

struct Options {
  std::filesystem::path out;
  int seconds = 40;
  trophic::World world;
  std::vector<std::filesystem::path> runs;
  std::size_t replicates = 0;
  std::uint64_t seed = 1;
  std::size_t jobs = std::max(1U, std::thread::hardware_concurrency());
  trophic::observe::Facts facts;
};

void check(const Options& options) {
  if (options.out.empty()) throw std::invalid_argument{"--out: must name a new folder"};
  if (options.seconds != 0 && (options.seconds < 10 || options.seconds > 1000 || options.seconds % 2 != 0)) {
    throw std::invalid_argument{"--seconds " + std::to_string(options.seconds) + ": must be 0 or an even number from 10 to 1000"};
  }
  if (options.replicates == 1) throw std::invalid_argument{"--replicates 1: must be 0 or >= 2, one run has no interval"};
  if (options.jobs == 0) throw std::invalid_argument{"--jobs 0: must be >= 1"};
  if (options.replicates != 0 && !options.runs.empty()) throw std::invalid_argument{"--runs: not with --replicates"};
  if (options.seconds == 0 && options.replicates == 0 && options.runs.empty()) {
    throw std::invalid_argument{"--seconds 0: needs --replicates or --runs, nothing is left to compare"};
  }
  trophic::validate(options.world, "world");
}

/// Walks that differ in engine, timestep or settings, MuJoCo's at the default timestep first.
struct Task {
  Condition condition;
  std::function<std::vector<cross_check::Walk>()> walk;
};
std::vector<Task> tasks_for(const trophic::Habitat& habitat, double target_angle_rad, double duration_s) {
  std::vector<Task> tasks;
  const auto add = [&]<class B>(const std::string& settings, double timestep_s, const typename B::Params& params) {
    const Condition condition{std::string{B::name}, settings, timestep_s, target_angle_rad};
    tasks.push_back({condition, [=, &habitat] { return cross_check::walk<B>(habitat, condition, duration_s, params); }});
  };
  const std::string unchanged{cross_check::default_settings};
  const double usual_s = trophic::Physics{}.timestep_s;
  for (const double finer : {1.0, 2.0, 4.0}) add.operator()<Mujoco>(unchanged, usual_s / finer, {});
  for (const double finer : {1.0, 2.0, 4.0}) add.operator()<Ode>(unchanged, usual_s / finer, {});
  Ode::Params many_sweeps;
  many_sweeps.sweeps = 100;
  add.operator()<Ode>("100 sweeps", usual_s, many_sweeps);
  Ode::Params world_step;
  world_step.solver = trophic::backend::ode::Solver::world_step;
  add.operator()<Ode>("world_step", usual_s, world_step);
  Ode::Params hard;  // half the time constant, the same damping ratio
  hard.contact_stiffness_N_m *= 4.0;
  hard.contact_damping_N_s_m *= 2.0;
  hard.friction_damping_N_s_m *= 2.0;
  add.operator()<Ode>("springs 4x", usual_s, hard);
  Ode::Params creeping;
  creeping.friction_damping_N_s_m /= 10.0;
  add.operator()<Ode>("creep 10x", usual_s, creeping);
  return tasks;
}

void compare_gaits(const Options& options, const trophic::Habitat& habitat, cross_check::Csv& csv) {
  cross_check::GaitReport report{options.out, csv};
  for (const double target_angle_rad : {0.7, -0.7, 0.0}) {
    const auto tasks = tasks_for(habitat, target_angle_rad, options.seconds);
    std::vector<cross_check::Outcome> outcomes(tasks.size());
    const auto attempts = trophic::replicates::in_parallel(
        tasks.size(), options.jobs,
        [&](std::size_t i) {
          outcomes[i] = {tasks[i].condition, tasks[i].walk()};
        },
        [] { return true; });
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const Condition& c = tasks[i].condition;
      if (!attempts[i].error.empty()) {
        throw std::runtime_error{c.engine + ", " + c.settings + ", timestep_s = " + trophic::number_text(c.timestep_s) + ": " +
                                 attempts[i].error};
      }
    }
    report.add(outcomes);
  }
}

template <class B>
std::filesystem::path run_ecologies(const Options& options) {
  const std::filesystem::path folder = options.out / B::name;
  std::cout << "\n" << B::name << ": " << options.replicates << " replicates" << std::endl;
  typename trophic::Ecology<trophic::rules::Paper, B>::Params params;
  params.seed = options.seed;
  params.world = options.world;
  const auto outcome = trophic::replicates::run<trophic::rules::Paper, B>(
      params, {.out = folder, .master_seed = options.seed, .count = options.replicates, .jobs = options.jobs}, options.facts,
      std::cout);
  if (!outcome.all_complete()) throw std::runtime_error{outcome.unfinished.front()};
  return folder;
}

void run_program(const Options& options) {
  check(options);
  const trophic::Habitat habitat = trophic::load_habitat(options.world);
  std::optional<cross_check::Ecologies> sets;
  if (!options.runs.empty()) sets = cross_check::read_ecologies(options.runs[0], options.runs[1]);
  cross_check::Csv csv{trophic::observe::make_new_folder(options.out) / "cross_check.csv"};
  if (options.seconds != 0) compare_gaits(options, habitat, csv);
  if (options.replicates != 0) {
    const auto mujoco = run_ecologies<Mujoco>(options);
    sets = cross_check::read_ecologies(mujoco, run_ecologies<Ode>(options));
  }
  if (sets) cross_check::compare_ecologies(*sets, csv);
  std::cout << "files   " << options.out.string() << "\n" << std::flush;
  if (!std::cout) throw std::runtime_error{"cannot write to standard output"};
}

}  // namespace

int main(int argc, char** argv) {
  using namespace trophic::examples;
  Options options;
  options.facts = facts(argc, argv);
  CLI::App app{
      "Compares MuJoCo and ODE: speed, turning, servo power and torque of one gait by timestep and settings, and the metrics of "
      "the "
      "paper's rules, with two one-sided tests of equivalence each."};
  app.add_option("--out", options.out, "new folder for cross_check.csv, trajectories.csv and the replicates");
  app.add_option("--seconds", options.seconds, "simulated time of each walk, an even number; 0: no walks (40)");
  app.add_option("--robot", options.world.robot, "name or path of a robot file (spider)");
  app.add_option("--gait", options.world.gait, "name or path of a gait file (the robot's)");
  app.add_option("--replicates", options.replicates, "runs of the paper's rules on each engine; 0: none (0)");
  app.add_option("--duration", options.world.duration_s, "length of each run, seconds of the ecology's clock (6000)");
  app.add_option("--seed", options.seed, "of the replicates, the same on both engines (1)");
  app.add_option("--jobs", options.jobs, "walks or runs at a time (one per core); results do not depend on it");
  app.add_option("--runs", options.runs, "instead of --replicates: two folders that predator_prey --replicates made")
      ->expected(2);
  return run_command(app, argc, argv, "cross_check", [&] {
    run_program(options);
    return 0;
  });
}
