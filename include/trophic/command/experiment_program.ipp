// SPDX-License-Identifier: MIT
// The definitions of experiment_program.hpp.
#pragma once

#include <algorithm>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <thread>
#include <trophic/command/backends.hpp>
#include <trophic/command/experiment_program.hpp>
#include <trophic/command/output.hpp>
#include <trophic/command/provenance.hpp>
#include <trophic/command/run_command.hpp>
#include <trophic/command/words.hpp>
#include <trophic/load/toml_writer.hpp>
#include <trophic/observe/next_free_folder.hpp>
#include <trophic/observe/stop_on_signal.hpp>
#include <trophic/params/toml.hpp>
#include <utility>

namespace trophic::command {

TROPHIC_INLINE void apply(const ExperimentOptions& options, std::uint64_t& seed, EcologyParams& ecology) {
  if (options.seed) seed = *options.seed;
  if (options.duration_s) ecology.duration_s = *options.duration_s;
  if (options.robots) ecology.robots = *options.robots;
  if (options.robot) ecology.robot = *options.robot;
}

TROPHIC_INLINE int print_config(const std::string& table, const std::string& backend, const NamedParams& named_params) {
  TomlWriter writer;
  writer.put("rule_table", table);
  writer.put("engine", backend);
  writer.put_all(named_params);
  return print_text(writer.text());
}

TROPHIC_INLINE replicates::Plan plan_of(const ExperimentOptions& options, std::uint64_t master_seed) {
  const std::uint64_t cores = std::max(1U, std::thread::hardware_concurrency());
  return {.out = options.out,
          .master_seed = master_seed,
          .count = *options.replicates,
          .jobs = options.jobs.value_or(std::min(cores, *options.replicates)),
          .resume = options.resume,
          .replay_hz = replay_hz_of(options)};
}

TROPHIC_INLINE double replay_hz_of(const ExperimentOptions& options) {
  return options.replay_hz ? static_cast<double>(*options.replay_hz) : observe::default_replay_hz;
}

TROPHIC_INLINE int report_unfinished(const ExperimentOptions& options, const std::vector<std::string>& unfinished) {
  flush_output();
  if (unfinished.empty()) return 0;
  for (const std::string& sentence : unfinished) std::cerr << options.program << ": " << sentence << "\n";
  std::cerr << "the same command with --resume runs these and no others\n";
  return run_error;
}

TROPHIC_INLINE void report_run(observe::RunFolder& folder, const observe::Progress& progress, const View& view) {
  folder.manifest().add({{"wall_s", observe::short_text(progress.elapsed_s())}});
  const int signal = observe::StopOnSignal::caught();
  if (signal != 0) std::cout << "stopped by signal " << signal << " after the tick at hand\n";
  progress.summary(std::cout, view);
  std::cout << "files   " << folder.path().string() << "/{events,agents,phylogeny,genomes}.csv, manifest.json"
            << (folder.frame_hz() > 0.0 ? ", replay.trp" : "") << "\n";
  flush_output();
}

namespace detail {

/// The names of tables or backends, each once, in order.
[[nodiscard]] TROPHIC_INLINE std::vector<std::string> names_of(const std::vector<Pairing>& pairings, std::string Pairing::*name) {
  std::vector<std::string> names;
  for (const Pairing& pairing : pairings) {
    if (std::ranges::find(names, pairing.*name) == names.end()) names.push_back(pairing.*name);
  }
  return names;
}

/// Every path that some table has on some backend, each once.
[[nodiscard]] TROPHIC_INLINE std::vector<std::string> paths_of(const std::vector<Pairing>& pairings) {
  std::vector<std::string> paths;
  for (const Pairing& pairing : pairings) {
    for (const NamedParam& param : pairing.named_params()) {
      if (std::ranges::find(paths, param.path) == paths.end()) paths.push_back(param.path);
    }
  }
  return paths;
}

[[nodiscard]] TROPHIC_INLINE std::vector<Option> options_of(ExperimentOptions& options, const std::vector<Pairing>& pairings) {
  const auto tables = names_of(pairings, &Pairing::table);
  const auto backends = names_of(pairings, &Pairing::backend);
  return {
      {"--rules", &options.rules, "rule table: " + one_of(tables) + " (" + tables.front() + ")", tables},
      {"--backend", &options.backend, backend_help(backends), backends},
      {"--seed", &options.seed, "every random number follows from it (1)"},
      {"--duration", &options.duration_s, "length of the run, seconds of the ecology's clock (the table's)"},
      {"--robots", &options.robots, "number of bodies (the table's)"},
      {"--robot", &options.robot, "name or path of a robot file (the table's)"},
      {"--threads", &options.threads, "threads of the physics; results do not depend on it (all cores; 1 with --replicates)"},
      {"--replicates", &options.replicates,
       "number of runs, into OUT/replicate-00, ...; their seeds follow from --seed and are written to replicates.json"},
      {"--jobs", &options.jobs, "replicates at a time (one per core); results do not depend on it"},
      {"--resume", &options.resume, "run only the replicates that OUT lacks; incomplete ones are kept under another name"},
      {"--shadow", &options.shadow,
       "run the table's neutral shadow too, into OUT/shadow: the same rules, numbers and seeds, but nothing is inherited"},
      {"--config", &options.config, "TOML file with numbers, as --print-config writes it"},
      {"--set", &options.assignments, "PATH=VALUE, e.g. rules.mutation.sd=0.1; may be repeated; wins over --config",
       paths_of(pairings), Words::assigned},
      {"--out", &options.out, "new folder for the run's files (the next free runs/" + options.program + "-1, -2, ...)"},
      {"--replay-hz", &options.replay_hz,
       "frames of the recording in a simulated second: 0 (none), 5, 10 or 30 (5); nothing else of a run depends on it"},
      {"--save-mjcf", &options.save_mjcf,
       "write the model at the start as MJCF (opens in MuJoCo's simulate); without --out nothing is run"},
      {"--print-config", &options.print_config, "print every number as TOML and stop"},
      {"--print-table",
       &options.print_table,
       "print the rules with their numbers and sources, as markdown or latex, and stop",
       {"markdown", "latex"},
       Words::demanded},
  };
}

TROPHIC_INLINE void check(const ExperimentOptions& options) {
  if (options.threads == std::uint64_t{0}) throw std::invalid_argument{"--threads 0: must be >= 1"};
  if (!options.replicates && (options.jobs || options.resume || options.shadow)) {
    throw std::invalid_argument{"--jobs, --resume and --shadow: need --replicates"};
  }
  if (options.replicates && !options.save_mjcf.empty()) throw std::invalid_argument{"--save-mjcf: not with --replicates"};
  if (const auto hz = options.replay_hz; hz && *hz != 0 && *hz != 5 && *hz != 10 && *hz != 30) {
    throw std::invalid_argument{"--replay-hz " + std::to_string(*hz) + ": must be 0, 5, 10 or 30"};
  }
  if (options.resume && options.out.empty()) throw std::invalid_argument{"--resume: needs --out, the folder to go on in"};
}

[[nodiscard]] TROPHIC_INLINE int run_pairing(ExperimentOptions& options, const std::vector<Pairing>& pairings) {
  for (const Pairing& pairing : pairings) {
    const auto same = [&](const Pairing& p) { return p.table == pairing.table && p.backend == pairing.backend; };
    if (std::ranges::count_if(pairings, same) > 1) {
      throw std::invalid_argument{"two rule tables are called " + pairing.table + ": each needs a name of its own"};
    }
  }
  const Config config = read_config(options.config, options.assignments);
  const auto tables = names_of(pairings, &Pairing::table);
  const auto backends = names_of(pairings, &Pairing::backend);
  const std::string table = options.rules.value_or(config.rule_table.value_or(tables.front()));
  const std::string backend = options.backend.value_or(config.engine.value_or(std::string{default_backend}));
  if (std::ranges::find(tables, table) == tables.end()) {
    throw std::invalid_argument{must_be_one_of("--rules " + table, tables) + did_you_mean(nearest_word(table, tables))};
  }
  if (std::ranges::find(backends, backend) == backends.end()) {
    throw std::invalid_argument{about_missing_backend(backend, backends)};
  }
  check(options);
  check_made_for(config, table, backend);
  if (options.out.empty() && options.save_mjcf.empty()) {
    options.out = observe::next_free_folder(std::filesystem::path{"runs"} / options.program).string();
  }
  const auto chosen = std::ranges::find_if(pairings, [&](const Pairing& p) { return p.table == table && p.backend == backend; });
  return chosen->run(options, config);
}

}  // namespace detail

TROPHIC_INLINE int experiment_program(int argc, const char* const* argv, const std::vector<Pairing>& pairings,
                                      const std::string& backend_versions) {
  ExperimentOptions options;
  options.program = program_name(argv[0]);
  options.provenance = provenance(argc, argv);
  const auto tables = detail::names_of(pairings, &Pairing::table);
  return run_command(argc, argv,
                     {.name = {},
                      .about = "Runs an ecology of simulated robots by the rules of " + one_of(tables) +
                               ", and leaves its events, agents, phylogeny and genomes with a manifest in a new folder.",
                      .options = detail::options_of(options, pairings),
                      .work = [&] { return detail::run_pairing(options, pairings); },
                      .subcommands = {},
                      .version = version_text(backend_versions)});
}

}  // namespace trophic::command
