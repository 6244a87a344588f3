// SPDX-License-Identifier: MIT
// Definitions of sweep.hpp.
#include <algorithm>
#include <map>
#include <set>
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
#include <tools/replicates/parallel.hpp>
#include <tools/replicates/stop_on_signal.hpp>
#include <tools/sweep/folder.hpp>
#include <tools/sweep/make_run.hpp>
#include <trophic/backend/contract.hpp>

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
  return file.params.paired ? file.params.seed : replicates::seed_of(file.params.seed, cell);
}

/// The runs of a cell, or of its shadow, without their parameters.
inline void append_runs(const sweep::SweepFile& file, const PlannedRun& like, std::vector<PlannedRun>& plan) {
  const std::uint64_t master_seed = master_seed_of(file, like.cell);
  for (std::size_t replicate = 0; replicate < file.params.replicates; ++replicate) {
    PlannedRun run = like;
    run.index = plan.size();
    run.replicate = replicate;
    run.seed = replicates::seed_of(master_seed, replicate);
    run.output = file.params.output();
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

/// The numbers of cells: that of a plan's cell with the same settings, or else with the same ones but for the duration if there
/// is one such cell, or else the next.
class CellNumbers {
 public:
  explicit CellNumbers(const std::vector<PlannedRun>& there) {
    for (const PlannedRun& run : there) {
      next_ = std::max(next_, run.cell + 1);
      exact_.emplace(key(run, true), run.cell);
      similar_[key(run, false)].insert(run.cell);
    }
  }

  [[nodiscard]] std::size_t of(const PlannedRun& run) {
    const auto exact = exact_.find(key(run, true));
    const auto similar = similar_.find(key(run, false));
    if (exact != exact_.end()) return exact->second;
    return similar != similar_.end() && similar->second.size() == 1 ? *similar->second.begin() : next_++;
  }

 private:
  [[nodiscard]] static std::string key(const PlannedRun& run, bool with_duration) {
    std::map<std::string, std::string> settings;
    for (const auto& [path, value] : run.settings.items()) {
      if (with_duration || path != sweep::duration_path) settings.emplace(path, json_text(value));
    }
    return json_text({run.rule_table, run.engine, settings});
  }

  std::map<std::string, std::size_t> exact_;
  std::map<std::string, std::set<std::size_t>> similar_;
  std::size_t next_ = 0;
};

/// The lists of replicates with which `trophic analyze` finds a cell's runs.
[[nodiscard]] inline std::vector<sweep::NamedText> files_of(const sweep::SweepFile& file, const std::vector<PlannedRun>& plan) {
  std::vector<sweep::NamedText> files{{"sweep.toml", file.text}};
  for (const PlannedRun& run : plan) {
    if (run.replicate > 0) continue;
    replicates::Plan cell;
    cell.master_seed = master_seed_of(file, run.cell);
    cell.count = file.params.replicates;
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

/// The numbers of the runs that are to be made, those with the most work first, so that none of them is begun when all others
/// have ended.
[[nodiscard]] inline std::vector<std::size_t> chosen_runs(const ExperimentOptions& options, const std::vector<PlannedRun>& plan) {
  std::vector<std::size_t> runs{options.run.begin(), options.run.end()};
  std::ranges::sort(runs);
  runs.erase(std::unique(runs.begin(), runs.end()), runs.end());
  if (!runs.empty() && runs.back() >= plan.size()) {
    throw std::invalid_argument{"--run " + std::to_string(runs.back()) + ": must be < " + std::to_string(plan.size()) +
                                ", the number of runs in the plan"};
  }
  if (runs.empty()) {
    for (const PlannedRun& run : plan) runs.push_back(run.index);
  }
  std::ranges::stable_sort(runs, [&](std::size_t a, std::size_t b) { return plan[a].work > plan[b].work; });
  return runs;
}

/// Prints how many runs are complete, and a sentence for each that is not, and returns the exit code.
[[nodiscard]] inline int report(const ExperimentOptions& options, std::size_t runs,
                                const std::map<std::size_t, std::string>& unfinished, std::size_t diverged) {
  constexpr std::size_t most_sentences = 20;
  std::cout << runs - unfinished.size() << " of " << runs << " runs complete in " << options.out << "\n";
  flush_output();
  if (unfinished.empty()) return 0;
  std::size_t printed = 0;
  for (const auto& [run, sentence] : unfinished) {
    if (printed++ == most_sentences) break;
    std::cerr << options.program << ": " << sentence << "\n";
  }
  if (unfinished.size() > most_sentences) std::cerr << "and " << unfinished.size() - most_sentences << " more\n";
  if (diverged > 0) std::cerr << diverged << " diverged, as they will again with the same parameters\n";
  if (diverged < unfinished.size()) std::cerr << "the same command resumes these and no others\n";
  return replicates::StopOnSignal::caught() != 0 ? stopped : run_error;
}

}  // namespace detail::sweeps

std::vector<sweep::PlannedRun> plan_of(const sweep::SweepFile& file, const Offer& offer,
                                       const std::vector<sweep::PlannedRun>& there) {
  std::vector<sweep::PlannedRun> plan;
  detail::sweeps::CellNumbers numbers{there};
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
      sweep::PlannedRun like;
      like.rule_table = chosen->rule_table();
      like.engine = chosen->backend().name();
      like.settings = settings;
      const std::size_t own = numbers.of(like);
      for (const bool shadow : {false, true}) {
        if (shadow && !file.params.shadow) continue;
        const sweep::PlannedRun first = detail::sweeps::first_of(*chosen, settings, own, shadow);
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
  std::map<std::filesystem::path, std::size_t> places;
  for (const sweep::PlannedRun& run : there) places.emplace(run.folder, run.index);
  std::ranges::stable_sort(plan, {}, [&](const sweep::PlannedRun& run) {
    const auto place = places.find(run.folder);
    return place == places.end() ? there.size() : place->second;
  });
  for (std::size_t i = 0; i < plan.size(); ++i) plan[i].index = i;
  return plan;
}

int run_sweep(const ExperimentOptions& options, const Offer& offer) {
  const replicates::StopOnSignal stop;
  const detail::sweeps::Runner runner{options, offer, stop};
  if (options.sbatch == std::uint64_t{0}) throw std::invalid_argument{"--sbatch 0: must be >= 1"};
  if (options.jobs == std::uint64_t{0}) throw std::invalid_argument{"--jobs 0: must be >= 1"};
  const sweep::SweepFile file = sweep::read_sweep(options.sweep);
  const std::filesystem::path there = std::filesystem::path{options.out} / sweep::plan_name;
  const bool joins = !options.out.empty() && std::filesystem::exists(there);
  const auto plan = plan_of(file, offer, joins ? sweep::read_plan(there) : std::vector<sweep::PlannedRun>{});
  if (options.sbatch) return detail::sweeps::print_sbatch(options, file, plan, runner);
  if (options.dry_run) return detail::sweeps::dry_run(options, file, plan, runner);
  const std::vector<std::size_t> runs = detail::sweeps::chosen_runs(options, plan);
  sweep::make_or_join(options.out, plan, detail::sweeps::files_of(file, plan));
  if (options.plan) return print_text(std::to_string(plan.size()) + " runs planned in " + options.out + "\n");
  if (!options.accept_other_build) sweep::check_builds(options.out, plan);

  replicates::JointProgress progress{runs.size(), plan.front().until_s, std::cout};
  const auto attempts = replicates::in_parallel(
      runs.size(), options.jobs.value_or(std::max(1U, std::thread::hardware_concurrency())),
      [&](std::size_t i) {
        const sweep::PlannedRun& run = plan[runs[i]];
        const std::string remark = sweep::make_run(
            options.out, run, [&](const std::filesystem::path& folder) { runner.run(run, folder, progress); },
            !options.no_verify);
        if (!remark.empty()) std::cout << remark + "\n" << std::flush;
      },
      [&] { return stop.keep_running(); });
  std::map<std::size_t, std::string> unfinished;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::string error = attempts[i].started ? attempts[i].error : "not begun";
    if (!error.empty()) unfinished.emplace(runs[i], plan[runs[i]].folder.string() + ": " + error);
  }
  return detail::sweeps::report(options, runs.size(), unfinished, runner.diverged());
}

}  // namespace trophic::command
