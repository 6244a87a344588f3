// SPDX-License-Identifier: MIT
// The pre-experiment: evolves the gait of a robot. `evolve_gait --help` lists the options.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <trophic/gait_evolution/archive.hpp>
#include <trophic/gait_evolution/pre_experiment.hpp>
#include <trophic/gait_evolution/tables.hpp>
#include <trophic/load/robot.hpp>
#include <trophic/load/toml_writer.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/observe/run_folder.hpp>
#include <trophic/observe/stop_on_signal.hpp>
#include <trophic/params/toml.hpp>
#include <vector>
#ifdef TROPHIC_WITH_MUJOCO
#include <trophic/backend/mujoco.hpp>
#endif
#ifdef TROPHIC_WITH_ODE
#include <trophic/backend/ode.hpp>
#endif

#include "command.hpp"

namespace {

namespace gait_evolution = trophic::gait_evolution;
namespace observe = trophic::observe;

/// Everything that the command line says. What it leaves out comes from the configuration file, then from the table.
struct Options {
  std::optional<std::string> table;
  std::optional<std::string> fitness;
  std::optional<std::string> backend;
  std::optional<std::string> robot;
  std::optional<std::uint64_t> seed;
  std::optional<std::size_t> generations;
  std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
  std::string config;
  std::vector<std::string> assignments;
  std::string out;
  std::string resume;
  bool print_config = false;
};

#if defined(TROPHIC_WITH_MUJOCO) && defined(TROPHIC_WITH_ODE)
constexpr const char* backends = "mujoco or ode";
#elif defined(TROPHIC_WITH_MUJOCO)
constexpr const char* backends = "mujoco (this build has no ode)";
#else
constexpr const char* backends = "ode (this build has no mujoco)";
#endif
#ifdef TROPHIC_WITH_MUJOCO
constexpr const char* default_backend = "mujoco";
#else
constexpr const char* default_backend = "ode";
#endif

template <class Table, class Backend>
std::string settings_text(const gait_evolution::Numbers<Table, Backend>& numbers) {
  trophic::TomlWriter writer;
  writer.put("rule_table", Table::name);
  writer.put("fitness_rule", Table::Fitness::name);
  writer.put("engine", Backend::name);
  writer.put_all(trophic::settings_of(numbers));
  return writer.text();
}

template <class Table, class Backend>
void report(const gait_evolution::PreExperiment<Table, Backend>& experiment, std::size_t evaluations, double elapsed_s) {
  const gait_evolution::Lineage& lineage = experiment.lineage();
  const std::vector<double> fitness = gait_evolution::fitness_after(lineage, lineage.generations - 1);
  const double a_generation_s =
      elapsed_s / static_cast<double>(evaluations) * static_cast<double>(experiment.numbers().plan.children);
  const auto to_go = static_cast<double>(experiment.numbers().plan.generations + 1 - lineage.generations);
  std::cout << "generation " << lineage.generations - 1 << " of " << experiment.numbers().plan.generations << "  best "
            << fitness.front() << "  median " << gait_evolution::median(fitness) << "  "
            << observe::short_text(static_cast<double>(evaluations) / elapsed_s) << " evaluations/s  "
            << observe::duration_text(a_generation_s * to_go) << " left" << std::endl;
}

template <class Table, class Backend>
int run(const Options& options, const toml::table& config) {
  gait_evolution::Numbers<Table, Backend> numbers;
  trophic::read_numbers(numbers, config);
  for (const std::string& assignment : options.assignments) trophic::read_numbers(numbers, trophic::read_assignment(assignment));
  if (options.robot) numbers.robot = *options.robot;
  if (options.seed) numbers.seed = *options.seed;
  if (options.generations) numbers.plan.generations = *options.generations;
  trophic::validate(numbers, "");
  if (options.print_config) {
    std::cout << settings_text(numbers) << std::flush;
    if (!std::cout) throw std::runtime_error{"cannot write to standard output"};
    return 0;
  }
  gait_evolution::PreExperiment<Table, Backend> experiment{numbers, trophic::load_robot(numbers.robot)};
  std::filesystem::path folder = options.resume;
  if (options.resume.empty()) {
    if (options.out.empty()) throw std::invalid_argument{"--out: must name a new folder"};
    folder = observe::make_new_folder(options.out);
    trophic::replace_file(folder / "settings.toml", settings_text(numbers));
  } else if (std::filesystem::exists(folder / "checkpoint.toml")) {
    gait_evolution::resume(experiment, folder);
  }

  const observe::StopOnSignal stop;
  const observe::Stopwatch watch;
  const std::size_t before = experiment.lineage().individuals.size();
  gait_evolution::save(experiment, folder);
  while (!experiment.done() && experiment.next_generation(options.threads, [&] { return stop.keep_running(); })) {
    gait_evolution::save(experiment, folder);
    report(experiment, experiment.lineage().individuals.size() - before, watch.elapsed_s());
  }
  const std::size_t evaluations = experiment.lineage().individuals.size() - before;
  if (!experiment.done()) {
    std::cout << "stopped by signal " << observe::StopOnSignal::caught() << "; go on with --resume " << folder.string()
              << std::endl;
    return 0;
  }
  const std::size_t champion = experiment.lineage().champion();
  std::cout << experiment.robot().name << ": fitness " << experiment.lineage().individuals[champion].fitness << " (individual "
            << champion << "), " << evaluations << " evaluations in " << observe::duration_text(watch.elapsed_s()) << " on "
            << options.threads << " threads\nfiles   " << folder.string()
            << "/{gait,settings,checkpoint}.toml, {generations,phylogeny}.csv" << std::endl;
  if (!std::cout) throw std::runtime_error{"cannot write to standard output"};
  return 0;
}

template <class Table>
int run_on(const std::string& backend, const Options& options, const toml::table& config) {
#ifdef TROPHIC_WITH_MUJOCO
  if (backend == trophic::backend::Mujoco::name) return run<Table, trophic::backend::Mujoco>(options, config);
#endif
#ifdef TROPHIC_WITH_ODE
  if (backend == trophic::backend::Ode::name) return run<Table, trophic::backend::Ode>(options, config);
#endif
  if (backend == "kinematic") throw std::invalid_argument{"--backend kinematic: has no joints, so there is no gait to evolve"};
  throw std::invalid_argument{"--backend " + backend + ": must be " + backends};
}

template <class Table>
int run_table(const std::string& fitness, const std::string& backend, const Options& options, const toml::table& config) {
  if (fitness == gait_evolution::DisplacementMinusX::name) return run_on<Table>(backend, options, config);
  if (fitness == gait_evolution::SteeredDisplacement::name) {
    return run_on<gait_evolution::with_fitness<Table, gait_evolution::SteeredDisplacement>>(backend, options, config);
  }
  throw std::invalid_argument{"--fitness " + fitness + ": must be displacement_minus_x or steered_displacement"};
}

int run_program(const Options& options) {
  toml::table config;
  if (!options.resume.empty()) {
    const bool other = options.table || options.fitness || options.backend || options.robot || options.seed ||
                       options.generations || !options.config.empty() || !options.assignments.empty() || !options.out.empty();
    if (other) throw std::invalid_argument{"--resume: only --threads goes with it, everything else is in the folder"};
    config = trophic::read_toml(options.resume + "/settings.toml");
  } else if (!options.config.empty()) {
    config = trophic::read_toml(options.config);
  }
  const auto configured_table = trophic::take_choice(config, "rule_table");
  const auto configured_fitness = trophic::take_choice(config, "fitness_rule");
  const auto configured_backend = trophic::take_choice(config, "engine");
  const std::string table = options.table.value_or(configured_table.value_or("paper"));
  const std::string fitness = options.fitness.value_or(configured_fitness.value_or("displacement_minus_x"));
  const std::string backend = options.backend.value_or(configured_backend.value_or(default_backend));
  if (options.threads == 0) throw std::invalid_argument{"--threads 0: must be >= 1"};
  if (table == gait_evolution::Paper::name) return run_table<gait_evolution::Paper>(fitness, backend, options, config);
  if (table == gait_evolution::Released::name) return run_table<gait_evolution::Released>(fitness, backend, options, config);
  throw std::invalid_argument{"--table " + table + ": must be paper or released"};
}

}  // namespace

int main(int argc, char** argv) {
  using namespace trophic::examples;
  Options options;
  CLI::App app{"Evolves the CPPN that makes a robot's gait, by the paper's pre-experiment or that of its released code."};
  app.add_option("--robot", options.robot, "name or path of a robot file (spider)");
  app.add_option("--table", options.table, "pre-experiment: paper or released (paper)");
  app.add_option("--fitness", options.fitness, "displacement_minus_x or steered_displacement (displacement_minus_x)");
  app.add_option("--backend", options.backend, std::string{"physics: "} + backends + " (" + default_backend + ")");
  app.add_option("--seed", options.seed, "every random number follows from it (1)");
  app.add_option("--generations", options.generations, "after the founders (20)");
  app.add_option("--threads", options.threads, "evaluations at a time; results do not depend on it (all cores)");
  app.add_option("--config", options.config, "TOML file with numbers, as --print-config writes it");
  app.add_option("--set", options.assignments, "PATH=VALUE, e.g. trial.duration_s=20; may be repeated; wins over --config");
  app.add_option("--out", options.out, "new folder for the files; a checkpoint is written there after every generation");
  app.add_option("--resume", options.resume, "folder of a run that was stopped or killed: goes on where it was");
  app.add_flag("--print-config", options.print_config, "print every number as TOML and stop");
  return run_command(app, argc, argv, "evolve_gait", [&] { return run_program(options); });
}
