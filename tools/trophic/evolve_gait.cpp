// SPDX-License-Identifier: MIT
// `trophic evolve-gait`, the pre-experiment: evolves the gait of a robot.
#include "commands.hpp"

#include <thread>
#include <tools/command/backends.hpp>
#include <tools/command/config.hpp>
#include <tools/command/option.hpp>
#include <tools/command/output.hpp>
#include <tools/command/result_folder.hpp>
#include <tools/command/words.hpp>
#include <tools/gait_evolution/files.hpp>
#include <tools/replicates/stop_on_signal.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/io/next_free_folder.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/support/replace_file.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::command {

namespace detail::evolve_gait {

using namespace gait_evolution;

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
  bool print_config = false;
};

template <NamedEnum E>
[[nodiscard]] std::vector<std::string> words_of() {
  constexpr auto names = enum_names(E{});
  return {names.begin(), names.end()};
}

/// The enumerator of an option, else of the configuration file, else the first. Throws std::invalid_argument for another word.
template <NamedEnum E>
[[nodiscard]] E choice(const std::string& option, const std::optional<std::string>& given,
                       const std::optional<std::string>& configured) {
  const std::vector<std::string> words = words_of<E>();
  const std::string word = given.value_or(configured.value_or(words.front()));
  const auto found = std::ranges::find(words, word);
  if (found != words.end()) return static_cast<E>(found - words.begin());
  throw std::invalid_argument{must_be_one_of(option + " " + word, words) + did_you_mean(nearest_word(word, words))};
}

/// Makes the folder, or continues in one of the same settings.
void begin(PreExperiment& experiment, const std::filesystem::path& folder, std::optional<FolderLock>& alone) {
  const std::string settings = settings_text(experiment.params(), experiment.backend());
  if (!std::filesystem::exists(folder / "settings.toml") || read_whole_file(folder / "settings.toml") != settings) {
    ResultFolder made{folder};
    replace_file(made.path() / "settings.toml", settings);
    made.publish();
  }
  alone.emplace(folder);
  if (std::filesystem::exists(folder / "checkpoint.toml")) resume(experiment, folder);
  save(experiment, folder);
}

void report(const PreExperiment& experiment, std::size_t evaluations, double elapsed_s) {
  const Lineage& lineage = experiment.lineage();
  const Plan& plan = experiment.params().plan;
  const std::vector<double> fitness = lineage.fitness_after(lineage.generations - 1);
  const double a_generation_s = elapsed_s / static_cast<double>(evaluations) * static_cast<double>(plan.children);
  const auto to_go = static_cast<double>(plan.generations + 1 - lineage.generations);
  std::cout << "generation " << lineage.generations - 1 << " of " << plan.generations << "  best " << fitness.front()
            << "  worst " << fitness.back() << "  " << observe::short_text(static_cast<double>(evaluations) / elapsed_s)
            << " evaluations/s  " << observe::duration_text(a_generation_s * to_go) << " left" << std::endl;
}

[[nodiscard]] int evolve(PreExperiment& experiment, const std::filesystem::path& folder, std::size_t threads) {
  std::optional<FolderLock> alone;
  begin(experiment, folder, alone);
  const replicates::StopOnSignal stop;
  const observe::Stopwatch watch;
  const Lineage& lineage = experiment.lineage();
  const std::size_t before = lineage.individuals.size();
  while (!experiment.done() && experiment.next_generation(threads, [&] { return stop.keep_running(); })) {
    save(experiment, folder);
    report(experiment, lineage.individuals.size() - before, watch.elapsed_s());
  }
  if (!experiment.done()) {
    std::cout << "stopped by signal " << replicates::StopOnSignal::caught() << "; repeat the command to resume" << std::endl;
    return stopped;
  }
  if (!lineage.has_champion()) {
    throw std::runtime_error{"every trial of " + std::to_string(lineage.individuals.size()) +
                             " candidates diverged, so there is no gait: " + "physics.timestep_s = " +
                             number_text(experiment.params().physics.timestep_s) + " may be too long for " +
                             experiment.robot().name};
  }
  const std::size_t champion = lineage.champion();
  std::cout << experiment.robot().name << ": fitness " << lineage.individuals[champion].fitness << " (individual " << champion
            << "), " << lineage.individuals.size() - before << " evaluations in " << observe::duration_text(watch.elapsed_s())
            << " on " << threads << " threads\nfiles   " << shown(folder) << "/{gait,settings,checkpoint}.toml, phylogeny.csv\n";
  flush_output();
  return 0;
}

[[nodiscard]] int run(const Options& options) {
  if (options.threads == 0) throw std::invalid_argument{"--threads 0: must be >= 1"};
  Config config = read_config(options.config, options.assignments);
  const auto fitness = choice<FitnessRule>("--fitness", options.fitness, take_choice(config.parameters, "fitness_rule"));
  Params params = params_of(choice<Table>("--table", options.table, config.rule_table), fitness);
  BackendChoice backend = joint_driven_backend(options.backend.value_or(config.engine.value_or(std::string{default_backend})));
  check_made_for(config, std::string{enum_name(params.table)}, backend.name());
  const ParamRefs refs = param_refs_of(params, backend);
  apply_config(refs, config);
  if (options.robot) params.robot = *options.robot;
  if (options.seed) params.seed = *options.seed;
  if (options.generations) params.plan.generations = *options.generations;
  validate(refs);
  if (options.print_config) return print_text(settings_text(params, backend));
  PreExperiment experiment{params, backend, load_robot(params.robot)};
  const std::filesystem::path own = std::filesystem::path{"runs"} / experiment.robot().name;
  return evolve(experiment, options.out.empty() ? io::next_free_folder(own) : std::filesystem::path{options.out},
                options.threads);
}

}  // namespace detail::evolve_gait

/// The evolution of a gait, on a backend with joints.
Command evolve_gait() {
  using namespace detail::evolve_gait;
  const auto options = std::make_shared<Options>();
  return {
      .name = "evolve-gait",
      .about =
          "Evolves the CPPN that generates a robot's gait, as in the paper's pre-experiment or in that of its released code.",
      .options =
          {{"--robot", &options->robot, "name or path of a robot file (default: spider)"},
           {"--table", &options->table, "pre-experiment: paper or released (default: paper)", words_of<Table>()},
           {"--fitness", &options->fitness,
            "fitness: displacement_minus_x or steered_displacement (default: displacement_minus_x)", words_of<FitnessRule>()},
           {"--backend", &options->backend, backend_help(joint_driven_names())},
           {"--seed", &options->seed, "seed of all random numbers (default: 1)"},
           {"--generations", &options->generations, "generations after the founders (default: 20)"},
           {"--threads", &options->threads, "number of parallel evaluations (default: all cores); results do not depend on it"},
           {"--config", &options->config, "TOML file with parameters, in the format of --print-config"},
           {"--set", &options->assignments, "PATH=VALUE, e.g. trial.duration_s=20; may be repeated; overrides --config"},
           {"--out", &options->out,
            "folder for the files, with a checkpoint after every generation; repeat the command to resume (default: the next "
            "free runs/ROBOT-1, ...)"},
           {"--print-config", &options->print_config, "print every parameter as TOML, then exit"}},
      .work = [options] { return run(*options); },
      .subcommands = {},
      .version = {}};
}

}  // namespace trophic::command
