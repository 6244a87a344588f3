// SPDX-License-Identifier: MIT
// `trophic analyze`, from runs to results: metrics with intervals beside the paper's values and their nulls.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <trophic/analysis/metrics/run_set.hpp>
#include <trophic/analysis/report/claim_verdict.hpp>
#include <trophic/analysis/report/compare_sets.hpp>
#include <trophic/analysis/report/metrics_table.hpp>
#include <trophic/analysis/report/summary.hpp>
#include <trophic/analysis/report/summary_json.hpp>
#include <trophic/analysis/report/text_table.hpp>
#include <trophic/command/analyze_sweep.hpp>
#include <trophic/command/option.hpp>
#include <trophic/command/output.hpp>
#include <trophic/observe/run_folder.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/version.hpp>
#include <vector>

namespace trophic::command {

namespace detail::analyze {

struct Options {
  std::vector<std::string> runs;
  std::vector<std::string> compare;
  std::optional<std::string> shadow;
  std::optional<double> until_s;
  bool published = false;
  SweepOptions sweep;
  std::string out = "analysis";
};

inline void tell(const analysis::ShadowedSet& set) {
  for (const std::string& remark : set.ours.remarks) std::cerr << "trophic analyze: " << remark << "\n";
  if (!set.shadow) return;
  for (const std::string& remark : set.shadow->remarks) std::cerr << "trophic analyze: " << remark << "\n";
}

inline void finish(const std::filesystem::path& out, std::span<const analysis::ShadowedSet> sets,
                   const nlohmann::ordered_json& json) {
  analysis::write_metrics(out / "metrics.csv", sets);
  write_json(out / "summary.json", json);
  std::cout << "files   " << out.string() << "/{metrics.csv,summary.json}\n";
  flush_output();
}

[[nodiscard]] inline nlohmann::ordered_json json_of(std::span<const analysis::ShadowedSet> sets) {
  nlohmann::ordered_json json;
  json["trophic"] = trophic::version;
  for (const analysis::ShadowedSet& set : sets) {
    json["sets"].push_back(analysis::summary_json(set, analysis::summarize(set.ours.runs, set.shadow_runs())));
  }
  return json;
}

[[nodiscard]] inline std::vector<std::filesystem::path> folders(const std::vector<std::string>& names) {
  return {names.begin(), names.end()};
}

inline void measure(const Options& options) {
  const std::array sets{analysis::read_shadowed_set(folders(options.runs), options.shadow, options.until_s)};
  const auto out = observe::make_new_folder(options.out);
  tell(sets[0]);
  if (options.published) {
    analysis::print_claims(std::cout, sets[0].ours, analysis::judge_claims(sets[0].ours.runs));
  } else {
    analysis::print_table(std::cout, sets[0], analysis::summarize(sets[0].ours.runs, sets[0].shadow_runs()));
  }
  finish(out, sets, json_of(sets));
}

inline void compare(const Options& options) {
  const auto both = folders(options.compare);
  const auto read = [&](std::size_t i) {
    return analysis::read_shadowed_set(std::span{both}.subspan(i, 1), {}, options.until_s);
  };
  std::array sets{read(0), read(1)};
  analysis::check_comparable(sets[0].ours.manifests.front(), sets[1].ours.manifests.front());
  if (sets[0].ours.label == sets[1].ours.label) {
    sets[0].ours.label += " (a)";
    sets[1].ours.label += " (b)";
  }
  const auto out = observe::make_new_folder(options.out);
  for (const analysis::ShadowedSet& set : sets) tell(set);
  const auto differences = analysis::compare_sets(sets[0], sets[1]);
  analysis::print_differences(std::cout, sets[0], sets[1], differences);
  nlohmann::ordered_json json = json_of(sets);
  json["differences"] = analysis::differences_json(differences);
  finish(out, sets, json);
}

inline void run(const Options& options) {
  if (options.runs.empty() == options.compare.empty()) {
    throw std::invalid_argument{"either folders of runs, or --compare and two of them"};
  }
  if (!options.compare.empty() && (options.shadow || options.published)) {
    throw std::invalid_argument{"--compare: not with --shadow or --published"};
  }
  if (options.until_s && !(*options.until_s > 0.0 && std::isfinite(*options.until_s))) {
    throw std::invalid_argument{"--until " + number_text(*options.until_s) + ": must be > 0"};
  }
  for (const std::string& folder : options.compare) {
    if (analysis::is_sweep(folder))
      throw std::invalid_argument{"--compare " + folder + ": must be no sweep; name two of its cells"};
  }
  const auto sweep = std::ranges::find_if(options.runs, [](const std::string& folder) { return analysis::is_sweep(folder); });
  if (sweep != options.runs.end()) {
    if (options.runs.size() > 1) throw std::invalid_argument{*sweep + ": is a sweep, which must be analyzed alone"};
    if (options.shadow || options.published)
      throw std::invalid_argument{*sweep + ": is a sweep: not with --shadow or --published"};
    measure_sweep(*sweep, options.out, options.sweep, options.until_s);
    return;
  }
  options.sweep.check_none();
  options.compare.empty() ? measure(options) : compare(options);
}

}  // namespace detail::analyze

/// Metrics of runs, claims about them, and differences between two sets of them.
[[nodiscard]] inline Command analyze() {
  const auto options = std::make_shared<detail::analyze::Options>();
  return {
      .name = "analyze",
      .about =
          "Measures runs: the paper's metrics with 95 % intervals over runs, beside its published values and their nulls. The "
          "neutral shadow, runs in which nothing is inherited, is the null of every metric; it is found in RUNS/shadow. A "
          "sweep's "
          "cells are each compared with one of them, corrected for the number of comparisons.",
      .options = {{"runs", &options->runs,
                   "folders of runs, or of replicates, pooled, so they must have one fingerprint; or one folder of a sweep"},
                  {"--compare",
                   &options->compare,
                   "two such folders: the difference of every metric, raw and over their shadows",
                   {},
                   Words::suggested,
                   2},
                  {"--shadow", &options->shadow, "the runs' neutral shadow, where it is not in RUNS/shadow"},
                  {"--until", &options->until_s, "measure only the first seconds of every run"},
                  {"--published", &options->published,
                   "a verdict on every published claim: reproduced, not reproduced, undecided"},
                  {"--reference", &options->sweep.reference,
                   "of a sweep: the cell that all others are compared with (the first)"},
                  {"--metric", &options->sweep.metrics,
                   "of a sweep: compare only these: METRIC, METRIC:SPECIES or METRIC:SPECIES:GROUP; fewer comparisons need fewer "
                   "runs"},
                  {"--difference", &options->sweep.difference,
                   "of a sweep: how many replicates a difference of this size in --metric, in the tables' unit, would need"},
                  {"--allow-missing", &options->sweep.allow_missing, "of a sweep: leave out runs that are missing or incomplete"},
                  {"--jobs", &options->sweep.jobs, "of a sweep: runs measured at a time (1)"},
                  {"--out", &options->out, "new folder for the tables and summary.json (analysis)"}},
      .work =
          [options] {
            detail::analyze::run(*options);
            return 0;
          },
      .subcommands = {},
      .version = {}};
}

}  // namespace trophic::command
