// SPDX-License-Identifier: MIT
// Definitions of sweep.hpp.
#include <algorithm>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>
#include <thread>
#include <tools/command/backends.hpp>
#include <tools/command/output.hpp>
#include <tools/command/run_command.hpp>
#include <tools/command/words.hpp>
#include <tools/experiment/run_experiment.hpp>
#include <tools/experiment/sweep.hpp>
#include <tools/experiment/sweep_estimate.hpp>
#include <tools/replicates/folder.hpp>
#include <tools/replicates/joint_progress.hpp>
#include <tools/sweep/attempt.hpp>
#include <tools/sweep/claim.hpp>
#include <tools/sweep/folder.hpp>
#include <tools/sweep/work_through.hpp>
#include <trophic/backend/contract.hpp>
#include <trophic/observe/stop_on_signal.hpp>
#include <utility>

namespace trophic::command {

namespace detail::sweeps {

/// The choice that a cell makes under a key, taken out of its settings.
[[nodiscard]] inline std::string take(sweep::Settings& settings, const std::string& key, const std::string& otherwise) {
  const auto found = settings.find(key);
  if (found == settings.end()) return otherwise;
  if (!found->is_string()) throw std::invalid_argument{key + " = " + json_text(*found) + ": must be a text"};
  const std::string choice = found->get<std::string>();
  settings.erase(key);
  return choice;
}

/// The master seed of a cell's replicates.
[[nodiscard]] inline std::uint64_t master_seed_of(const sweep::SweepFile& file, std::size_t cell) {
  return file.numbers.paired ? file.numbers.seed : replicates::seed_of(file.numbers.seed, cell);
}

/// The runs of a cell, or of its shadow, without their parameters.
inline void append_runs(const sweep::SweepFile& file, const PlannedRun& like, std::vector<PlannedRun>& plan) {
  const std::uint64_t master_seed = master_seed_of(file, like.cell);
  for (std::size_t replicate = 0; replicate < file.numbers.replicates; ++replicate) {
    PlannedRun run = like;
    run.index = plan.size();
    run.replicate = replicate;
    run.seed = replicates::seed_of(master_seed, replicate);
    run.output = file.numbers.output();
    run.folder = like.folder / replicates::name_of(replicate);
    plan.push_back(std::move(run));
  }
}

[[nodiscard]] inline PlannedRun first_of(AnyExperiment& chosen, const sweep::Settings& settings, std::size_t cell, bool shadow) {
  const PlannedFacts facts = command::facts(chosen, config_of(settings), shadow);
  return {.index = 0,
          .cell = cell,
          .replicate = 0,
          .shadow = shadow,
          .rule_table = chosen.rule_table(),
          .engine = chosen.backend().name(),
          .settings = settings,
          .seed = 0,
          .until_s = facts.description.until_s,
          .work = facts.work,
          .folder = std::filesystem::path{cell_name(cell)} / (shadow ? "shadow" : ""),
          .fingerprint = facts.description.fingerprint};
}

/// The lists of replicates with which `trophic analyze` finds a cell's runs.
[[nodiscard]] inline std::vector<sweep::NamedText> files_of(const sweep::SweepFile& file, const std::vector<PlannedRun>& plan) {
  std::vector<sweep::NamedText> files{{"sweep.toml", file.text}};
  for (const PlannedRun& run : plan) {
    if (run.replicate > 0) continue;
    replicates::Plan cell;
    cell.master_seed = master_seed_of(file, run.cell);
    cell.count = file.numbers.replicates;
    const observe::RunDescription description{.rules = run.rule_table,
                                              .slots = {},
                                              .named_params = {},
                                              .tags = {},
                                              .backend = run.engine,
                                              .remarks = {},
                                              .seed = run.seed,
                                              .until_s = run.until_s,
                                              .fingerprint = run.fingerprint};
    files.emplace_back(run.folder.parent_path() / replicates::list_name, replicates::list_text(cell, description, {}));
  }
  return files;
}

/// Prints how many runs are complete and returns the exit code.
[[nodiscard]] inline int report(const ExperimentOptions& options, const sweep::Tally& tally, std::size_t diverged) {
  constexpr std::size_t most_sentences = 20;
  const std::size_t complete = tally.kept + tally.complete;
  std::cout << complete << " of " << complete + tally.unfinished.size() << " runs complete in " << options.out << "\n";
  flush_output();
  if (tally.unfinished.empty()) return 0;
  for (std::size_t i = 0; i < std::min(most_sentences, tally.unfinished.size()); ++i) {
    std::cerr << options.program << ": " << tally.unfinished[i] << "\n";
  }
  if (tally.unfinished.size() > most_sentences) {
    std::cerr << "and " << tally.unfinished.size() - most_sentences << " more\n";
  }
  if (diverged > 0) std::cerr << diverged << " diverged, as they will again with the same parameters\n";
  if (diverged < tally.unfinished.size()) std::cerr << "the same command resumes these and no others\n";
  return observe::StopOnSignal::caught() != 0 ? stopped : run_error;
}

inline void check(const ExperimentOptions& options, const sweep::Team* team) {
  const auto refuse = [](bool given, const std::string& option, const std::string& instead) {
    if (given) throw std::invalid_argument{option + ": not with --sweep; " + instead};
  };
  const std::string in_file = "its file has it";
  refuse(options.rules.has_value(), "--rules", in_file);
  refuse(options.backend.has_value(), "--backend", in_file);
  refuse(options.seed.has_value(), "--seed", in_file);
  refuse(options.duration_s.has_value(), "--duration", in_file);
  refuse(options.robots.has_value(), "--robots", in_file);
  refuse(options.robot.has_value(), "--robot", in_file);
  refuse(options.replicates.has_value(), "--replicates", in_file);
  refuse(options.shadow, "--shadow", in_file);
  refuse(options.replay_hz.has_value(), "--replay-hz", in_file);
  refuse(options.agents_every != 1, "--agents-every", in_file);
  refuse(options.senses, "--senses", in_file);
  refuse(options.states, "--states", in_file);
  refuse(!options.config.empty(), "--config", in_file);
  refuse(!options.assignments.empty(), "--set", "its section [set] does the same");
  refuse(options.resume, "--resume", "a sweep always resumes what is not complete");
  refuse(!options.from.empty(), "--from", "each run begins at its beginning");
  refuse(options.threads.has_value(), "--threads", "each run has one thread; see --jobs");
  refuse(!options.save_mjcf.empty(), "--save-mjcf", "run one cell for it");
  refuse(options.print_config || !options.print_table.empty(), "--print-config and --print-table", "run one cell for it");
  if (options.out.empty() && !options.dry_run) {
    throw std::invalid_argument{"--sweep: needs --out, the folder that all its programs share"};
  }
  if (options.sbatch == std::uint64_t{0}) throw std::invalid_argument{"--sbatch 0: must be >= 1"};
  if (options.jobs == std::uint64_t{0}) throw std::invalid_argument{"--jobs 0: must be >= 1"};
  if (options.lease_s && !(*options.lease_s >= 1.0)) {
    throw std::invalid_argument{"--lease-s " + number_text(*options.lease_s) + ": must be >= 1"};
  }
  if (team == nullptr) return;
  refuse(!options.shard.empty(), "--shard", "MPI hands out the runs");
  refuse(options.jobs.has_value(), "--jobs", "under MPI each rank makes one run at a time");
  refuse(options.dry_run || options.sbatch, "--dry-run and --sbatch", "start it without mpirun");
  if (team->size() < 2) {
    throw std::invalid_argument{"mpirun -n 1: needs at least 2 ranks, as rank 0 hands out the runs; without mpirun, see --jobs"};
  }
}

}  // namespace detail::sweeps

std::vector<sweep::PlannedRun> plan_of(const sweep::SweepFile& file, const Offer& offer) {
  std::vector<sweep::PlannedRun> plan;
  std::map<std::pair<std::string, double>, std::size_t> seen;
  std::size_t number = 0;
  const auto cells = sweep::cells_of(file);
  for (const sweep::Settings& cell : cells) {
    const std::string text = sweep::text_of(cell, file);
    const std::string name = file.path.string() + ": cell " + std::to_string(number) + (text.empty() ? "" : " (" + text + ")");
    try {
      sweep::Settings settings = cell;
      const std::string table = detail::sweeps::take(settings, "rule_table", offer.rule_tables.front().first);
      const std::string engine = detail::sweeps::take(settings, "engine", offer.default_backend);
      const auto chosen = detail::sweeps::experiment_of(table, engine, offer);
      for (const bool shadow : {false, true}) {
        if (shadow && !file.numbers.shadow) continue;
        const sweep::PlannedRun first = detail::sweeps::first_of(*chosen, settings, number, shadow);
        if (!shadow) {
          const auto [other, is_new] = seen.emplace(std::pair{first.fingerprint, first.until_s}, number);
          if (!is_new) throw std::invalid_argument{"is the same experiment as cell " + std::to_string(other->second)};
        }
        detail::sweeps::append_runs(file, first, plan);
      }
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument{name + ": " + error.what()};
    }
    ++number;
  }
  return plan;
}

int run_sweep(const ExperimentOptions& options, const Offer& offer, sweep::Team* team) {
  const bool leads = team == nullptr || team->leads();
  const observe::StopOnSignal stop;
  const detail::sweeps::Runner runner{options, offer, stop};
  std::vector<sweep::PlannedRun> plan;
  sweep::Shard shard;
  try {
    detail::sweeps::check(options, team);
    const sweep::SweepFile file = sweep::read_sweep(options.sweep);
    if (!options.shard.empty()) shard = sweep::shard_of(options.shard);
    if (leads) {
      plan = plan_of(file, offer);
      if (options.sbatch) return detail::sweeps::print_sbatch(options, file, plan, runner);
      if (options.dry_run) return detail::sweeps::dry_run(options, file, plan, runner);
      sweep::make_or_join(options.out, plan, detail::sweeps::files_of(file, plan));
      if (!options.accept_other_build) sweep::check_builds(options.out, plan);
    }
  } catch (const std::exception&) {
    if (team != nullptr) static_cast<void>(team->begin(false));
    // All ranks find the same fault; one reports it.
    if (!leads) return usage_error;
    throw;
  }
  if (team != nullptr) {
    if (!team->begin(true)) return usage_error;
    if (!leads) plan = sweep::read_plan(std::filesystem::path{options.out} / sweep::plan_name);
  }

  const std::size_t runs = sweep::longest_first(plan, shard).size();
  observe::JointProgress progress{runs, plan.front().until_s, std::cout};
  const double lease_s = options.lease_s.value_or(sweep::default_lease_s);
  const auto attempt = [&](const sweep::PlannedRun& run) {
    return sweep::attempt(options.out, run, lease_s,
                          [&](const std::filesystem::path& folder) { runner.run(run, folder, progress); });
  };
  const auto keep_running = [&] { return stop.keep_running(); };
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const sweep::Tally tally = team != nullptr
                                 ? team->distribute(plan, options.out, lease_s, attempt, keep_running)
                                 : sweep::work_through(plan, shard, options.jobs.value_or(cores), attempt, keep_running);
  if (!leads) return 0;
  sweep::remove_claims(options.out, plan);
  return detail::sweeps::report(options, tally, runner.diverged());
}

}  // namespace trophic::command
