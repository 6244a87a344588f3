// SPDX-License-Identifier: MIT
// Definitions of run_plan.hpp.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <thread>
#include <tools/changes/changing_simulation.hpp>
#include <tools/command/backends.hpp>
#include <tools/command/config.hpp>
#include <tools/command/output.hpp>
#include <tools/command/run_command.hpp>
#include <tools/command/toml_of_json.hpp>
#include <tools/command/words.hpp>
#include <tools/experiment/run_experiment.hpp>
#include <tools/experiment/run_plan.hpp>
#include <tools/plan/make_run.hpp>
#include <tools/plan/plan_file.hpp>
#include <tools/reading/read_history.hpp>
#include <tools/replicates/joint_progress.hpp>
#include <tools/replicates/parallel.hpp>
#include <tools/replicates/stop_on_signal.hpp>
#include <trophic/backend/contract.hpp>
#include <trophic/observe/print_remarks.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::command {

namespace detail::plans {

using plan::PlannedRun;
using plan::Stage;

/// Settings as a configuration file has them.
[[nodiscard]] inline Config config_of(const Json& settings) {
  Config config{.origin = {}, .file = {}, .parameters = {}, .rule_table = {}, .engine = {}, .assignments = {}};
  for (const auto& [path, value] : settings.items()) {
    if (path == "seed" || path == "backend.threads") throw std::invalid_argument{path + ": is not allowed in a plan"};
    insert_at(config.parameters, path, value);
  }
  return config;
}

[[nodiscard]] inline std::unique_ptr<AnyExperiment> experiment_of(const PlannedRun& run, const Offer& offer) {
  const auto check = [](const std::string& key, const std::string& name, const std::vector<std::string>& names) {
    if (std::ranges::find(names, name) != names.end()) return;
    throw std::invalid_argument{key + " = " + must_be_one_of(name, names) + did_you_mean(nearest_word(name, names))};
  };
  check("rule_table", run.rule_table, table_names(offer));
  check("engine", run.engine, backend_names(offer.backends));
  return find_experiment(offer, run.rule_table, run.engine);
}

/// Equal for runs that differ in their seed alone.
[[nodiscard]] inline std::string kind_of(const PlannedRun& run) {
  return json_text({run.rule_table, run.engine, run.settings, name_of(run.null)});
}

/// A plan on what the program offers.
class Runner {
 public:
  Runner(const ExperimentOptions& options, const Offer& offer, plan::Lines lines = plan::Lines::described)
      : options_{options},
        offer_{offer},
        path_{options.plan},
        folder_{path_.has_parent_path() ? path_.parent_path() : "."},
        runs_{plan::read_plan(path_, lines)} {
    for (PlannedRun& run : runs_) {
      if (run.rule_table.empty()) run.rule_table = offer.rule_tables.front().first;
      if (run.engine.empty()) run.engine = default_backend_of(offer, run.rule_table);
    }
  }

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] const std::vector<PlannedRun>& runs() const { return runs_; }

  /// A run as this program makes it. Throws std::invalid_argument "PLAN:LINE: ..." for one that it cannot make.
  [[nodiscard]] const PlannedFacts& facts(std::size_t index) {
    const PlannedRun& run = runs_[index];
    const auto [found, is_new] = facts_.try_emplace(kind_of(run));
    if (!is_new) return found->second;
    try {
      found->second = command::facts(*experiment_of(run, offer_), config_of(run.settings), run.null);
    } catch (const std::logic_error& error) {  // a RuleError, too
      throw std::invalid_argument{plan::place_of(path_, index) + error.what()};
    }
    return found->second;
  }

  /// Throws std::invalid_argument if this program would make another run than the one that was planned.
  void check(std::size_t index) {
    const PlannedRun& run = runs_[index];
    const auto same = [&](const std::string& field, const Json& there, const Json& here) {
      if (there == here) return;
      throw std::invalid_argument{plan::place_of(path_, index) + field + " = " + json_text(there) + ": must be " +
                                  json_text(here) + " in this program; rules, models or engine changed"};
    };
    same("fingerprint", run.fingerprint, facts(index).description.fingerprint);
    same("until_s", run.until_s, facts(index).description.until_s);
  }

  /// Makes a run, unless it is complete.
  void make(std::size_t index, replicates::JointProgress& progress, const replicates::StopOnSignal& stop) {
    const PlannedRun& run = runs_[index];
    const auto work = [&](const std::filesystem::path& folder) {
      replicates::CommonOptions common{
          options_.provenance, schedule_of(options_), run.output, {}, changes::with_changes(options_.own_tables)};
      common.provenance.emplace_back("planned_run", std::to_string(index));
      const std::string remark = run_planned(*experiment_of(run, offer_), config_of(run.settings), run.null, history_of(run),
                                             run.seed, folder, common, {progress.watch(run.folder.string()), stop});
      if (!remark.empty()) std::cout << shown(run.folder) + " " + remark + "\n" << std::flush;
    };
    try {
      plan::make_run(folder_, run, work, !options_.no_verify);
    } catch (const Diverged&) {
      ++diverged_;
      throw;
    }
  }

  /// The number of runs that diverged, which they do again with the same parameters.
  [[nodiscard]] std::size_t diverged() const { return diverged_; }

 private:
  /// The history that a neutral null repeats: that of the plan's run of the same experiment and seed.
  [[nodiscard]] HistoryOf history_of(const PlannedRun& run) const {
    if (run.null != Null::neutral) return {};
    PlannedRun repeated = run;
    repeated.null = Null::none;
    const std::string kind = kind_of(repeated);
    const auto of =
        std::ranges::find_if(runs_, [&](const PlannedRun& one) { return one.seed == run.seed && kind_of(one) == kind; });
    if (of == runs_.end()) throw std::invalid_argument{"null = neutral: needs the run that it repeats in the plan"};
    if (!plan::is_complete(folder_, *of)) throw std::invalid_argument{"needs " + of->folder.string() + " to be complete"};
    return [folder = folder_ / of->folder](std::uint64_t) { return replicates::read_history(folder); };
  }

  const ExperimentOptions& options_;
  const Offer& offer_;
  std::filesystem::path path_;
  std::filesystem::path folder_;
  std::vector<PlannedRun> runs_;
  std::map<std::string, PlannedFacts> facts_;
  std::atomic<std::size_t> diverged_ = 0;
};

/// The numbers of the runs that are to be made: the first run of every cell and null, then the second of each, so that a plan
/// that is cut short has runs of all. Of these, those with the most work come first. Neutral nulls, which repeat other runs, come
/// last.
[[nodiscard]] inline std::vector<std::size_t> chosen_runs(const ExperimentOptions& options, const std::vector<PlannedRun>& plan) {
  std::vector<std::size_t> runs{options.run.begin(), options.run.end()};
  std::ranges::sort(runs);
  runs.erase(std::unique(runs.begin(), runs.end()), runs.end());
  if (!runs.empty() && runs.back() >= plan.size()) {
    throw std::invalid_argument{"--run " + std::to_string(runs.back()) + ": must be < " + std::to_string(plan.size()) +
                                ", the number of runs in the plan"};
  }
  if (runs.empty()) {
    runs.resize(plan.size());
    std::iota(runs.begin(), runs.end(), std::size_t{0});
  }
  std::map<std::string, std::size_t> of_kind;
  std::vector<std::size_t> round(plan.size());
  for (std::size_t i = 0; i < plan.size(); ++i) round[i] = of_kind[kind_of(plan[i])]++;
  const auto before = [&](std::size_t i) { return std::tuple{plan[i].null == Null::neutral, round[i], -plan[i].work}; };
  std::ranges::stable_sort(runs, {}, before);
  return runs;
}

/// Prints how many runs are complete, and a sentence for each that is not, and returns the exit code.
[[nodiscard]] inline int report(const ExperimentOptions& options, std::size_t runs,
                                const std::map<std::size_t, std::string>& unfinished, std::size_t diverged) {
  constexpr std::size_t most_sentences = 20;
  std::cout << runs - unfinished.size() << " of " << runs << " runs complete in " << shown(options.plan) << "\n";
  flush_output();
  if (unfinished.empty()) return 0;
  std::size_t printed = 0;
  for (const auto& [run, sentence] : unfinished) {
    if (printed++ == most_sentences) break;
    std::cerr << options.program << ": " << sentence << "\n";
  }
  if (unfinished.size() > most_sentences) std::cerr << "and " << unfinished.size() - most_sentences << " more\n";
  if (diverged > 0) std::cerr << diverged << " diverged, and will diverge again with the same parameters\n";
  if (diverged < unfinished.size()) std::cerr << "to resume only these, repeat the command\n";
  return replicates::StopOnSignal::caught() != 0 ? stopped : run_error;
}

/// Prints what this program says of each run of a draft, a JSON object a line.
[[nodiscard]] inline int describe_plan(const ExperimentOptions& options, const Offer& offer) {
  Runner runner{options, offer, plan::Lines::drafts};
  std::string text;
  for (std::size_t i = 0; i < runner.runs().size(); ++i) {
    const PlannedFacts& facts = runner.facts(i);
    const PlannedRun& run = runner.runs()[i];
    text += json_text({{"rule_table", run.rule_table},
                       {"engine", run.engine},
                       {"until_s", facts.description.until_s},
                       {"work", facts.work},
                       {"fingerprint", facts.description.fingerprint},
                       {"species", facts.species}}) +
            "\n";
  }
  return print_text(text);
}

/// The wall time in a run's manifest; 0 if there is none.
[[nodiscard]] inline double wall_s_of(const std::filesystem::path& run) {
  const Json json = parse_json_or_null(read_whole_file(run / "manifest.json"));
  if (!json.is_object() || !json.contains("wall_s") || !json["wall_s"].is_string()) return 0.0;
  return std::strtod(json["wall_s"].get<std::string>().c_str(), nullptr);
}

/// A line of the first few names.
[[nodiscard]] inline std::string names_line(const std::string& title, const std::vector<std::string>& names) {
  constexpr std::size_t shown = 5;
  std::string line = "  " + title + ": ";
  for (std::size_t i = 0; i < std::min(shown, names.size()); ++i) line += (i > 0 ? ", " : "") + names[i];
  return line + (names.size() > shown ? ", and " + std::to_string(names.size() - shown) + " more" : "") + "\n";
}

/// The time that the runs of a table on an engine took, and the work that was done and is left.
struct Spent {
  double wall_s = 0.0;
  double done = 0.0;
  double left = 0.0;
};

/// Prints how many runs are done, running, failed, interrupted and missing, and the time left.
[[nodiscard]] inline int print_status(const Runner& runner, bool verifies) {
  std::map<std::pair<std::string, std::string>, Spent> kinds;
  std::map<Stage, std::vector<std::string>> runs;
  for (const PlannedRun& run : runner.runs()) {
    const Stage stage = plan::stage_of(runner.folder(), run, verifies);
    runs[stage].push_back(run.folder.string());
    Spent& spent = kinds[{run.rule_table, run.engine}];
    const double wall_s = stage == Stage::complete ? wall_s_of(runner.folder() / run.folder) : 0.0;
    spent.wall_s += wall_s;
    (stage != Stage::complete ? spent.left : spent.done) += wall_s > 0.0 || stage != Stage::complete ? run.work : 0.0;
  }
  const std::array stages{std::pair{Stage::complete, "done"}, std::pair{Stage::running, "running"},
                          std::pair{Stage::failed, "failed"}, std::pair{Stage::interrupted, "interrupted"},
                          std::pair{Stage::missing, "missing"}};
  std::string text = shown(runner.folder()) + ": " + std::to_string(runner.runs().size()) + " runs";
  for (const auto& [stage, name] : stages) {
    text += (stage == Stage::complete ? ": " : ", ") + std::to_string(runs[stage].size()) + " " + name;
  }
  text += "\n";
  for (const auto& [stage, name] : std::span{stages}.subspan(1, 3)) {
    if (!runs[stage].empty()) text += names_line(name, runs[stage]);
  }
  if (runs[Stage::complete].size() == runner.runs().size()) return print_text(text);
  double left_s = 0.0;
  for (const auto& [kind, spent] : kinds) {
    if (spent.left > 0.0) left_s += spent.left * spent.wall_s / spent.done;  // unknown: not a number
  }
  if (!std::isfinite(left_s)) {
    return print_text(
        text +
        "left: unknown, because some rule table and engine has no finished run yet; trophic plan --dry-run estimates it\n");
  }
  return print_text(text + "left: about " + observe::duration_text(left_s) + " of one core (" +
                    number_text(std::ceil(left_s / 36.0) / 100.0) + " core-hours), estimated from the finished runs\n");
}

}  // namespace detail::plans

int run_plan(const ExperimentOptions& options, const Offer& offer) {
  if (options.describe) return detail::plans::describe_plan(options, offer);
  detail::plans::Runner runner{options, offer};
  if (options.status) return detail::plans::print_status(runner, !options.no_verify);
  if (options.jobs == std::uint64_t{0}) throw std::invalid_argument{"--jobs 0: must be >= 1"};
  const replicates::StopOnSignal stop;
  const std::vector<std::size_t> runs = detail::plans::chosen_runs(options, runner.runs());
  for (const std::size_t run : runs) {
    if (plan::is_complete(runner.folder(), runner.runs()[run])) continue;
    runner.check(run);
    observe::print_remarks(runner.facts(run).description.remarks);
  }
  if (!options.accept_other_build) plan::check_builds(runner.folder(), runner.runs());

  replicates::JointProgress progress{runs.size(), runner.runs().front().until_s, std::cout};
  const std::uint64_t jobs = options.jobs.value_or(std::max(1U, std::thread::hardware_concurrency()));
  std::map<std::size_t, std::string> unfinished;
  const auto make = [&](std::span<const std::size_t> some) {
    const auto attempts = replicates::in_parallel(
        some.size(), jobs, [&](std::size_t i) { runner.make(some[i], progress, stop); }, [&] { return stop.keep_running(); });
    for (std::size_t i = 0; i < some.size(); ++i) {
      const std::string error = attempts[i].started ? attempts[i].error : "not begun";
      if (!error.empty()) unfinished.emplace(some[i], runner.runs()[some[i]].folder.string() + ": " + error);
    }
  };
  const auto repeats = std::ranges::find(runs, Null::neutral, [&](std::size_t run) { return runner.runs()[run].null; });
  make({runs.begin(), repeats});
  make({repeats, runs.end()});
  return detail::plans::report(options, runs.size(), unfinished, runner.diverged());
}

}  // namespace trophic::command
