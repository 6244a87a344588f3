// SPDX-License-Identifier: MIT
// The paper's experiment: predators and prey, modular robots, one arena. `predator_prey --help` lists the options.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/load/habitat.hpp>
#include <trophic/load/toml_writer.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/observe/run_folder.hpp>
#include <trophic/observe/stop_on_signal.hpp>
#include <trophic/params/toml.hpp>
#include <trophic/replicates/run_with_shadow.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
#include <vector>
#ifdef TROPHIC_WITH_MUJOCO
#include <trophic/backend/mujoco.hpp>
#endif
#ifdef TROPHIC_WITH_ODE
#include <trophic/backend/ode.hpp>
#endif

#include "command.hpp"
#include "facts.hpp"

namespace {

/// Everything that the command line says. What it leaves out comes from the configuration file, then from the rule table.
struct Options {
  std::optional<std::string> rules;
  std::optional<std::string> backend;
  std::optional<std::uint64_t> seed;
  std::optional<double> duration_s;
  std::optional<std::size_t> robots;
  std::optional<std::string> robot;
  std::optional<std::size_t> threads;
  std::optional<std::size_t> replicates;
  std::optional<std::size_t> jobs;
  bool resume = false;
  bool shadow = false;
  std::string config;
  std::vector<std::string> assignments;
  std::string out;
  std::string save_mjcf;
  bool print_config = false;
  trophic::observe::Facts facts;
};

/// What this build was made with.
constexpr const char* backends =
    "kinematic"
#ifdef TROPHIC_WITH_MUJOCO
    ", mujoco"
#endif
#ifdef TROPHIC_WITH_ODE
    ", ode"
#endif
    ;
#ifdef TROPHIC_WITH_MUJOCO
constexpr const char* default_backend = "mujoco";
#else
constexpr const char* default_backend = "kinematic";
#endif

template <class Rules, class Backend>
auto resolve(const Options& options, const toml::table& config) {
  typename trophic::Ecology<Rules, Backend>::Params params;
  if constexpr (requires { params.backend.threads; }) {
    params.backend.threads = std::max<std::size_t>(1, std::thread::hardware_concurrency());
  }
  trophic::read_numbers(params, config);
  for (const std::string& assignment : options.assignments) trophic::read_numbers(params, trophic::read_assignment(assignment));
  if (options.seed) params.seed = *options.seed;
  if (options.duration_s) params.world.duration_s = *options.duration_s;
  if (options.robots) params.world.robots = *options.robots;
  if (options.robot) params.world.robot = *options.robot;
  if constexpr (requires { params.backend.threads; }) {
    if (options.threads) params.backend.threads = *options.threads;
  }
  trophic::validate(params, "");
  return params;
}

/// The replicates of a table and, where asked, of its neutral shadow, with the same seeds.
template <class Rules, class Backend>
int run_replicates(const Options& options, trophic::Experiment<Rules, Backend> params) {
  if constexpr (requires { params.backend.threads; }) params.backend.threads = options.threads.value_or(1);
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const trophic::replicates::Plan plan{.out = options.out,
                                       .master_seed = params.seed,
                                       .count = *options.replicates,
                                       .jobs = options.jobs.value_or(std::min(cores, *options.replicates)),
                                       .resume = options.resume};
  const auto unfinished =
      trophic::replicates::run_with_shadow<Rules, Backend>(params, plan, options.shadow, options.facts, std::cout);
  if (!std::cout) throw std::runtime_error{"cannot write to standard output"};
  if (unfinished.empty()) return 0;
  for (const std::string& sentence : unfinished) std::cerr << "predator_prey: " << sentence << "\n";
  std::cerr << "the same command with --resume runs these and no others\n";
  return trophic::examples::run_error;
}

template <class Rules, class Backend>
int run(const Options& options, const toml::table& config) {
  if (options.threads == std::size_t{0}) throw std::invalid_argument{"--threads 0: must be >= 1"};
  if (!options.replicates && (options.jobs || options.resume || options.shadow)) {
    throw std::invalid_argument{"--jobs, --resume and --shadow: need --replicates"};
  }
  if (options.replicates && !options.save_mjcf.empty()) throw std::invalid_argument{"--save-mjcf: not with --replicates"};
  const auto params = resolve<Rules, Backend>(options, config);
  if (options.print_config) {
    std::cout << "rule_table = \"" << trophic::table_name<Rules>() << "\"\nengine = \"" << Backend::name << "\"\n"
              << trophic::toml_text(trophic::settings_of(params)) << std::flush;
    if (!std::cout) throw std::runtime_error{"cannot write to standard output"};
    return 0;
  }
  if (options.replicates) return run_replicates<Rules, Backend>(options, params);
  trophic::Ecology<Rules, Backend> ecology{params};
  if (!options.save_mjcf.empty()) {
    if constexpr (requires { ecology.backend().save_mjcf(options.save_mjcf); }) {
      ecology.backend().save_mjcf(options.save_mjcf);
    } else {
      throw std::invalid_argument{"--save-mjcf: needs --backend mujoco"};
    }
    if (options.out.empty()) return 0;
  }
  if (options.out.empty()) throw std::invalid_argument{"--out: must name a new folder"};

  const trophic::observe::StopOnSignal stop;
  trophic::observe::RunFolder folder{options.out, options.facts};
  trophic::observe::Progress progress;
  try {
    ecology.run_until(params.world.duration_s, folder, progress, stop);
  } catch (const std::exception& error) {
    std::cerr << "predator_prey: " << error.what() << "\nwhat was written before is in " << folder.path().string() << "\n";
    return trophic::examples::run_error;
  }
  folder.manifest().add({{"wall_s", trophic::observe::short_text(progress.elapsed_s())}});
  if (stop.caught() != 0) std::cout << "stopped by signal " << stop.caught() << " after the tick at hand\n";
  progress.summary(std::cout, ecology.view());
  std::cout << "files   " << folder.path().string() << "/{events,agents,phylogeny,genomes}.csv, manifest.json\n" << std::flush;
  if (!std::cout) throw std::runtime_error{"cannot write to standard output"};
  return 0;
}

template <class Rules>
int run_on(const std::string& backend, const Options& options, const toml::table& config) {
  if (backend == trophic::backend::Kinematic::name) return run<Rules, trophic::backend::Kinematic>(options, config);
#ifdef TROPHIC_WITH_MUJOCO
  if (backend == trophic::backend::Mujoco::name) return run<Rules, trophic::backend::Mujoco>(options, config);
#endif
#ifdef TROPHIC_WITH_ODE
  if (backend == trophic::backend::Ode::name) return run<Rules, trophic::backend::Ode>(options, config);
#endif
  throw std::invalid_argument{"--backend " + backend + ": must be one of " + backends};
}

int run_program(const Options& options) {
  toml::table config;
  if (!options.config.empty()) config = trophic::read_toml(options.config);
  const auto configured_rules = trophic::take_choice(config, "rule_table");
  const auto configured_backend = trophic::take_choice(config, "engine");
  const std::string rules = options.rules.value_or(configured_rules.value_or("paper"));
  const std::string backend = options.backend.value_or(configured_backend.value_or(default_backend));
  if (rules == trophic::rules::Paper::name) return run_on<trophic::rules::Paper>(backend, options, config);
  if (rules == trophic::rules::Released::name) return run_on<trophic::rules::Released>(backend, options, config);
  throw std::invalid_argument{"--rules " + rules + ": must be paper or released"};
}

}  // namespace

int main(int argc, char** argv) {
  using namespace trophic::examples;
  Options options;
  options.facts = facts(argc, argv);

  CLI::App app{
      "Predators and prey with evolving controllers in modular robots, by the paper's rules or those of its released code."};
  app.add_option("--rules", options.rules, "rule table: paper or released (paper)");
  app.add_option("--backend", options.backend, std::string{"physics: "} + backends + " (" + default_backend + ")");
  app.add_option("--seed", options.seed, "every random number follows from it (1)");
  app.add_option("--duration", options.duration_s, "length of the run, seconds of the ecology's clock (6000)");
  app.add_option("--robots", options.robots, "number of bodies (30)");
  app.add_option("--robot", options.robot, "name or path of a robot file (spider)");
  app.add_option("--threads", options.threads,
                 "threads of the physics; results do not depend on it (all cores; 1 with --replicates)");
  app.add_option("--replicates", options.replicates,
                 "number of runs, into OUT/replicate-00, ...; their seeds follow from --seed and are written to replicates.json");
  app.add_option("--jobs", options.jobs, "replicates at a time (one per core); results do not depend on it");
  app.add_flag("--resume", options.resume, "run only the replicates that OUT lacks; incomplete ones are kept under another name");
  app.add_flag(
      "--shadow", options.shadow,
      "run the table's neutral shadow too, into OUT/shadow: the same rules, numbers and seeds, but nothing is inherited");
  app.add_option("--config", options.config, "TOML file with numbers, as --print-config writes it");
  app.add_option("--set", options.assignments, "PATH=VALUE, e.g. rules.mutation.sd=0.1; may be repeated; wins over --config");
  app.add_option("--out", options.out, "new folder for the run's files");
  app.add_option("--save-mjcf", options.save_mjcf,
                 "write the model at the start as MJCF (opens in MuJoCo's simulate); without --out nothing is run");
  app.add_flag("--print-config", options.print_config, "print every number as TOML and stop");
  return run_command(app, argc, argv, "predator_prey", [&] { return run_program(options); });
}
