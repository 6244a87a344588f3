// SPDX-License-Identifier: MIT
// `trophic evolve-gait`, the pre-experiment: evolves the gait of a robot.
#include "commands.hpp"

#include <thread>
#include <tools/command/backends.hpp>
#include <tools/command/config.hpp>
#include <tools/command/option.hpp>
#include <tools/command/output.hpp>
#include <tools/command/read_parameters.hpp>
#include <tools/command/result_folder.hpp>
#include <tools/command/toml_writer.hpp>
#include <tools/command/words.hpp>
#include <tools/gait_evolution/archive.hpp>
#include <tools/gait_evolution/pre_experiment.hpp>
#include <tools/gait_evolution/tables.hpp>
#include <tools/replicates/stop_on_signal.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::command {

namespace detail::evolve_gait {

/// Options of the command line. Missing ones come from the configuration file, then from the table.
struct Options {
  std::optional<std::string> table;
  std::optional<std::string> fitness;
  std::optional<std::string> backend;
  std::optional<std::string> robot;
  std::optional<std::uint64_t> seed;
  std::optional<std::uint64_t> generations;
  std::uint64_t threads = std::max(1U, std::thread::hardware_concurrency());
  std::string config;
  std::vector<std::string> assignments;
  std::string out;
  std::string resume;
  bool print_config = false;
};

template <class Table>
std::string settings_text(const gait_evolution::Params<Table>& parameters, const BackendChoice& backend) {
  TomlWriter writer;
  writer.put("rule_table", Table::name);
  writer.put("fitness_rule", Table::Fitness::name);
  writer.put("engine", backend.name());
  writer.put_all(gait_evolution::named_params_of(parameters, backend));
  return writer.text();
}

template <class Table>
void report(const gait_evolution::PreExperiment<Table>& experiment, std::size_t evaluations, double elapsed_s) {
  const gait_evolution::Lineage& lineage = experiment.lineage();
  const std::vector<double> fitness = gait_evolution::fitness_after(lineage, lineage.generations - 1);
  const double a_generation_s =
      elapsed_s / static_cast<double>(evaluations) * static_cast<double>(experiment.params().plan.children);
  const auto to_go = static_cast<double>(experiment.params().plan.generations + 1 - lineage.generations);
  std::cout << "generation " << lineage.generations - 1 << " of " << experiment.params().plan.generations << "  best "
            << fitness.front() << "  median " << gait_evolution::median(fitness) << "  "
            << observe::short_text(static_cast<double>(evaluations) / elapsed_s) << " evaluations/s  "
            << observe::duration_text(a_generation_s * to_go) << " left" << std::endl;
}

template <class Table>
int run(BackendChoice backend, const Options& options, const Config& config) {
  gait_evolution::Params<Table> parameters;
  apply_config(gait_evolution::param_refs_of(parameters, backend), config);
  if (options.robot) parameters.robot = *options.robot;
  if (options.seed) parameters.seed = *options.seed;
  if (options.generations) parameters.plan.generations = *options.generations;
  validate(gait_evolution::param_refs_of(parameters, backend));
  if (options.print_config) {
    return print_text(settings_text(parameters, backend));
  }
  gait_evolution::PreExperiment<Table> experiment{parameters, backend, load_robot(parameters.robot)};
  const std::filesystem::path folder = options.resume.empty() ? options.out : options.resume;
  if (folder.empty()) throw std::invalid_argument{"--out: must name a new folder"};
  const std::filesystem::path begun = folder / "settings.toml";
  const std::string settings = settings_text(parameters, backend);
  const bool is_new = options.resume.empty() && !(std::filesystem::exists(begun) && read_whole_file(begun) == settings);
  if (is_new) {
    ResultFolder made{folder};
    replace_file(made.path() / "settings.toml", settings);
    made.publish();
  }
  const FolderLock alone{folder};
  if (!is_new && std::filesystem::exists(folder / "checkpoint.toml")) {
    gait_evolution::resume(experiment, folder);
  }

  const replicates::StopOnSignal stop;
  const observe::Stopwatch watch;
  const std::size_t before = experiment.lineage().individuals.size();
  gait_evolution::save(experiment, folder);
  while (!experiment.done() && experiment.next_generation(options.threads, [&] { return stop.keep_running(); })) {
    gait_evolution::save(experiment, folder);
    report(experiment, experiment.lineage().individuals.size() - before, watch.elapsed_s());
  }
  const std::size_t evaluations = experiment.lineage().individuals.size() - before;
  if (!experiment.done()) {
    std::cout << "stopped by signal " << replicates::StopOnSignal::caught() << "; continue with --resume " << folder.string()
              << std::endl;
    return stopped;
  }
  if (!gait_evolution::has_champion(experiment)) {
    throw std::runtime_error{"every trial of " + std::to_string(experiment.lineage().individuals.size()) +
                             " candidates diverged, so there is no gait: physics.timestep_s = " +
                             number_text(parameters.physics.timestep_s) + " may be too long for " + experiment.robot().name};
  }
  const std::size_t champion = experiment.lineage().champion();
  std::cout << experiment.robot().name << ": fitness " << experiment.lineage().individuals[champion].fitness << " (individual "
            << champion << "), " << evaluations << " evaluations in " << observe::duration_text(watch.elapsed_s()) << " on "
            << options.threads << " threads\nfiles   " << folder.string()
            << "/{gait,settings,checkpoint}.toml, {generations,phylogeny}.csv\n";
  flush_output();
  return 0;
}

template <class Table>
[[nodiscard]] int run_table(const std::string& fitness, const BackendChoice& backend, const Options& options,
                            const Config& config) {
  using Steered = gait_evolution::with_fitness<Table, gait_evolution::SteeredDisplacement>;
  if (fitness == gait_evolution::DisplacementMinusX::name) {
    return run<Table>(backend, options, config);
  }
  if (fitness == gait_evolution::SteeredDisplacement::name) {
    return run<Steered>(backend, options, config);
  }
  const std::vector<std::string> names{std::string{gait_evolution::DisplacementMinusX::name},
                                       std::string{gait_evolution::SteeredDisplacement::name}};
  throw std::invalid_argument{must_be_one_of("--fitness " + fitness, names) + did_you_mean(nearest_word(fitness, names))};
}

[[nodiscard]] int run_program(const Options& options) {
  if (!options.resume.empty()) {
    const bool other = options.table || options.fitness || options.backend || options.robot || options.seed ||
                       options.generations || !options.config.empty() || !options.assignments.empty() || !options.out.empty();
    if (other) throw std::invalid_argument{"--resume: only --threads goes with it, everything else is in the folder"};
  }
  Config config = read_config(options.resume.empty() ? options.config : options.resume + "/settings.toml", options.assignments);
  const auto configured_fitness = take_choice(config.parameters, "fitness_rule");
  const std::string table = options.table.value_or(config.rule_table.value_or("paper"));
  const std::string fitness = options.fitness.value_or(configured_fitness.value_or("displacement_minus_x"));
  const std::string backend = options.backend.value_or(config.engine.value_or(std::string{default_backend}));
  if (options.threads == 0) throw std::invalid_argument{"--threads 0: must be >= 1"};
  check_made_for(config, table, backend);
  if (table == gait_evolution::Paper::name)
    return run_table<gait_evolution::Paper>(fitness, joint_driven_backend(backend), options, config);
  if (table == gait_evolution::Released::name) {
    return run_table<gait_evolution::Released>(fitness, joint_driven_backend(backend), options, config);
  }
  throw std::invalid_argument{"--table " + table + ": must be paper or released"};
}

}  // namespace detail::evolve_gait

/// The evolution of a gait, on a backend with joints.
Command evolve_gait() {
  const auto options = std::make_shared<detail::evolve_gait::Options>();
  const auto backends = joint_driven_names();
  return {
      .name = "evolve-gait",
      .about = "Evolves the CPPN that makes a robot's gait, by the paper's pre-experiment or that of its released code.",
      .options = {{"--robot", &options->robot, "name or path of a robot file (spider)"},
                  {"--table", &options->table, "pre-experiment: paper or released (paper)", {"paper", "released"}},
                  {"--fitness",
                   &options->fitness,
                   "displacement_minus_x or steered_displacement (displacement_minus_x)",
                   {"displacement_minus_x", "steered_displacement"}},
                  {"--backend", &options->backend, backend_help(backends)},
                  {"--seed", &options->seed, "every random number follows from it (1)"},
                  {"--generations", &options->generations, "after the founders (20)"},
                  {"--threads", &options->threads, "evaluations at a time; results do not depend on it (all cores)"},
                  {"--config", &options->config, "TOML file with parameters, as --print-config writes it"},
                  {"--set", &options->assignments, "PATH=VALUE, e.g. trial.duration_s=20; may be repeated; wins over --config"},
                  {"--out", &options->out,
                   "folder for the files, with a checkpoint after every generation; the same command again continues"},
                  {"--resume", &options->resume, "folder of a run that was stopped or killed: continues it"},
                  {"--print-config", &options->print_config, "print every parameter as TOML and stop"}},
      .work = [options] { return detail::evolve_gait::run_program(*options); },
      .subcommands = {},
      .version = {}};
}

}  // namespace trophic::command
