// SPDX-License-Identifier: MIT
// `trophic cross-check`, what depends on the engine: one gait in MuJoCo and ODE at several timesteps and settings, and the
// metrics of two sets of runs.
#include "commands.hpp"

#include <thread>
#include <tools/command/backends.hpp>
#ifdef TROPHIC_WITH_MUJOCO
#include <trophic/backend/mujoco.hpp>
#endif
#ifdef TROPHIC_WITH_ODE
#include <trophic/backend/ode.hpp>
#endif
#include <tools/command/option.hpp>
#include <tools/command/output.hpp>
#include <tools/command/result_folder.hpp>
#include <tools/command/run_python.hpp>
#include <tools/reading/pooled_runs.hpp>
#include <tools/replicates/parallel.hpp>
#include <tools/replicates/stop_on_signal.hpp>
#include <tools/trophic/cross_check/walk_tables.hpp>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/habitat/load/habitat.hpp>

namespace trophic::command {

namespace cross_check {

struct Options {
  std::string out;
  std::uint64_t seconds = 40;
  EcologyParams ecology;
  std::vector<std::string> runs;
  std::uint64_t jobs = std::max(1U, std::thread::hardware_concurrency());
};

void check(const Options& options) {
  if (options.out.empty()) throw std::invalid_argument{"--out: must name a new folder"};
  if (options.seconds != 0 && (options.seconds < 10 || options.seconds > 1000 || options.seconds % 2 != 0)) {
    throw std::invalid_argument{"--seconds " + std::to_string(options.seconds) + ": must be 0 or an even number from 10 to 1000"};
  }
  if (options.jobs == 0) throw std::invalid_argument{"--jobs 0: must be >= 1"};
  if (options.seconds == 0 && options.runs.empty()) {
    throw std::invalid_argument{"--seconds 0: needs --runs, nothing is left to compare"};
  }
  validate(options.ecology, "ecology");
}

/// Throws std::invalid_argument unless the rules, the parameters other than the engine's, and the durations of two sets are the
/// same.
void check_same_rules(const std::filesystem::path& first, const std::filesystem::path& second) {
  const auto first_of = [](const std::filesystem::path& folder) {
    return analysis::pooled_runs(std::span{&folder, 1}, false).manifests.front();
  };
  const analysis::RunManifest a = first_of(first);
  const analysis::RunManifest b = first_of(second);
  const auto of_the_ecology = [](const analysis::RunManifest& manifest) {
    Json rest{{"rule_table", manifest.rules}, {"rules", manifest.policies}, {"params", manifest.params}};
    for (const char* own : {"seed", "physics", "backend"}) rest["params"].erase(own);
    if (rest["params"].contains("ecology")) rest["params"]["ecology"].erase("duration_s");
    return rest;
  };
  if (const std::string why = analysis::first_difference(of_the_ecology(a), of_the_ecology(b)); !why.empty()) {
    throw std::invalid_argument{second.string() + ": " + why + " as in " + first.string()};
  }
  if (!analysis::lasted_alike(a, b)) {
    throw std::invalid_argument{second.string() + ": " + analysis::lasted_text(b) + ": must be as " + analysis::lasted_text(a) +
                                ", as in " + first.string()};
  }
}

#if defined(TROPHIC_WITH_MUJOCO) && defined(TROPHIC_WITH_ODE)
/// Walks that differ in engine, timestep or settings, MuJoCo's at the default timestep first.
struct Task {
  Condition condition;
  std::function<std::vector<Walk>()> walk;
};
[[nodiscard]] std::vector<Task> tasks_for(const Habitat& habitat, double target_angle_rad, double duration_s) {
  std::vector<Task> tasks;
  const auto add = [&](const std::string& settings, double timestep_s, const BackendChoice& backend) {
    const Condition condition{backend.name(), settings, timestep_s, target_angle_rad};
    tasks.push_back({condition, [=, &habitat] { return walk(habitat, condition, duration_s, backend); }});
  };
  const std::string unchanged{default_settings};
  const double usual_s = Physics{}.timestep_s;
  for (const double finer : {1.0, 2.0, 4.0}) add(unchanged, usual_s / finer, backend::Mujoco::Params{});
  for (const double finer : {1.0, 2.0, 4.0}) add(unchanged, usual_s / finer, backend::Ode::Params{});
  backend::Ode::Params many_sweeps;
  many_sweeps.sweeps = 100;
  add("100 sweeps", usual_s, many_sweeps);
  backend::Ode::Params world_step;
  world_step.solver = backend::ode::Solver::world_step;
  add("world_step", usual_s, world_step);
  backend::Ode::Params hard;  // half the time constant, the same damping ratio
  hard.contact_stiffness_N_m *= 4.0;
  hard.contact_damping_N_s_m *= 2.0;
  hard.friction_damping_N_s_m *= 2.0;
  add("springs 4x", usual_s, hard);
  backend::Ode::Params creeping;
  creeping.friction_damping_N_s_m /= 10.0;
  add("creep 10x", usual_s, creeping);
  return tasks;
}

/// Writes the walks of all tasks into a folder, unless a signal stops it.
void walk_all(const Options& options, const Habitat& habitat, const std::filesystem::path& folder) {
  const replicates::StopOnSignal stop;
  WalkTables tables{folder};
  for (const double target_angle_rad : {0.7, -0.7, 0.0}) {
    const auto tasks = tasks_for(habitat, target_angle_rad, static_cast<double>(options.seconds));
    std::vector<Outcome> outcomes(tasks.size());
    const auto attempts = replicates::in_parallel(
        tasks.size(), options.jobs,
        [&](std::size_t i) {
          outcomes[i] = {tasks[i].condition, tasks[i].walk()};
        },
        [&] { return stop.keep_running(); });
    if (!stop.keep_running()) return;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const Condition& c = tasks[i].condition;
      if (!attempts[i].error.empty()) {
        throw std::runtime_error{c.engine + ", " + c.settings + ", timestep_s = " + number_text(c.timestep_s) + ": " +
                                 attempts[i].error};
      }
    }
    for (const Outcome& outcome : outcomes) tables.write(outcome);
  }
}

#endif

[[nodiscard]] int run(const Options& options) {
  check(options);
  const Habitat habitat = load_habitat(options.ecology);
  if (!options.runs.empty()) check_same_rules(options.runs[0], options.runs[1]);
#if !defined(TROPHIC_WITH_MUJOCO) || !defined(TROPHIC_WITH_ODE)
  if (options.seconds != 0) {
    throw std::invalid_argument{"--seconds " + std::to_string(options.seconds) +
                                ": must be 0, walks need both engines and this program was built with " +
                                backend_versions(built_backends())};
  }
#endif
  const ResultFolder folder{options.out};
#if defined(TROPHIC_WITH_MUJOCO) && defined(TROPHIC_WITH_ODE)
  if (options.seconds != 0) walk_all(options, habitat, folder.path());
  if (replicates::StopOnSignal::caught() != 0) return stopped;
#endif
  return run_python({{"command", "cross-check"},
                     {"who", "trophic cross-check"},
                     {"folder", folder.path().string()},
                     {"out", options.out},
                     {"runs", options.runs}});
}

}  // namespace cross_check

/// Walks and runs on two engines, with tests of equivalence.
Command cross_check_engines() {
  const auto options = std::make_shared<cross_check::Options>();
  return {.name = "cross-check",
          .about =
              "Compares MuJoCo and ODE: speed, turning, servo power and torque of one gait by timestep and settings, and the "
              "metrics of two sets of runs, with two one-sided tests of equivalence each. Needs Python with pandas and scipy.",
          .options = {{"--out", &options->out, "new folder for cross_check.csv, walks.csv and trajectories.csv"},
                      {"--seconds", &options->seconds, "simulated time of each walk, an even number; 0: no walks (40)"},
                      {"--robot", &options->ecology.robot, "name or path of a robot file (spider)"},
                      {"--gait", &options->ecology.gait, "name or path of a gait file (the robot's)"},
                      {"--jobs", &options->jobs, "walks at a time (one per core); results do not depend on it"},
                      {"--runs",
                       &options->runs,
                       "two folders of replicates of the same rules, each on one engine: which metrics are equivalent",
                       {},
                       2}},
          .work = [options] { return cross_check::run(*options); },
          .subcommands = {},
          .version = {}};
}

}  // namespace trophic::command
