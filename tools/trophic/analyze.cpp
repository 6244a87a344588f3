// SPDX-License-Identifier: MIT
// `trophic analyze`, from runs to results: metrics with intervals beside the paper's values and their nulls.
#include "commands.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tools/analysis/metrics/run_set.hpp>
#include <tools/analysis/report/claim_conclusion.hpp>
#include <tools/analysis/report/claims_text.hpp>
#include <tools/analysis/report/compare_sets.hpp>
#include <tools/analysis/report/metrics_table.hpp>
#include <tools/analysis/report/summary.hpp>
#include <tools/analysis/report/summary_json.hpp>
#include <tools/analysis/report/text_table.hpp>
#include <tools/trophic/analysis_page.hpp>
#include <tools/trophic/analyze_sweep.hpp>
#include <tools/trophic/replay/page.hpp>
#include <tools/trophic/replay/recorded_run.hpp>
#include <trophic/command/option.hpp>
#include <trophic/command/output.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/new_file.hpp>
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
  bool accept_other_build = false;
  SweepOptions sweep;
  std::optional<std::string> out;
  std::string html;
  std::string figures;
  std::optional<std::uint64_t> replays;
};

inline constexpr std::uint64_t default_replays = 2;
inline constexpr std::uint64_t most_replays = 20;

/// Where tables go: where --out says, else into "analysis", unless a page is all that is asked for.
[[nodiscard]] std::optional<std::filesystem::path> make_out(const Options& options) {
  if (!options.out && !options.html.empty()) return std::nullopt;
  return io::make_new_folder(options.out.value_or("analysis"));
}

void tell(const analysis::ShadowedSet& set) {
  for (const std::string& remark : set.ours.remarks) std::cerr << "trophic analyze: " << remark << "\n";
  if (!set.shadow) return;
  for (const std::string& remark : set.shadow->remarks) std::cerr << "trophic analyze: " << remark << "\n";
}

/// The first runs of the sets as a viewer shows them; what cannot be shown is told of.
[[nodiscard]] std::vector<AnalysisPage::Replay> replays_of(const Options& options, std::span<const analysis::ShadowedSet> sets) {
  std::vector<AnalysisPage::Replay> replays;
  const std::uint64_t most = options.replays.value_or(default_replays);
  try {
    if (most > 0) static_cast<void>(replay::viewer_page());
    for (const analysis::ShadowedSet& set : sets) {
      for (std::size_t i = 0; i < std::min<std::size_t>(most, set.ours.manifests.size()); ++i) {
        const std::filesystem::path& folder = set.ours.manifests[i].folder;
        const std::vector<replay::RecordedRun> runs{replay::open_run(folder)};
        for (const std::string& remark : runs[0].remarks) std::cerr << "trophic analyze: " << remark << "\n";
        const std::string name = folder.lexically_normal().filename().string();
        replays.push_back({.label = sets.size() > 1 ? set.ours.label + " " + name : name, .part = replay::runs_part(runs, {})});
      }
    }
  } catch (const std::invalid_argument& error) {
    if (options.replays) throw;
    std::cerr << "trophic analyze: no replays: " << error.what() << "\n";
    replays.clear();
  }
  return replays;
}

void write_page(const Options& options, std::span<const analysis::ShadowedSet> sets, const std::string& table) {
  AnalysisPage page{.title = "", .facts = {}, .table = table, .figures = {}, .replays = replays_of(options, sets)};
  for (const analysis::ShadowedSet& set : sets) {
    const analysis::RunManifest& first = set.ours.manifests.front();
    page.title += (page.title.empty() ? "" : " and ") + set.ours.label + " on " + first.backend;
    page.facts.emplace_back(set.ours.label,
                            std::to_string(set.ours.runs.size()) + " runs of " + number_text(first.until_s) + " s" +
                                (set.shadow ? ", " + std::to_string(set.shadow->runs.size()) + " of the shadow" : "") +
                                ", fingerprint " + first.fingerprint);
  }
  page.facts.emplace_back("analysed by", "trophic " + std::string{trophic::version});
  if (!options.figures.empty()) page.figures = read_figures(options.figures);
  const std::string html = html_of(page);
  write_new_file(options.html, html);
  std::cout << "page    " << options.html << ": " << page.figures.size() << " figures, " << page.replays.size() << " replays, "
            << megabytes_text(html.size()) << "\n";
}

void finish(const Options& options, const std::optional<std::filesystem::path>& out, std::span<const analysis::ShadowedSet> sets,
            const Json& json, const std::string& table) {
  std::cout << table;
  if (out) {
    analysis::write_metrics(*out / "metrics.csv", sets);
    write_json(*out / "summary.json", json);
    std::cout << "files   " << out->string() << "/{metrics.csv,summary.json}\n";
  }
  if (!options.html.empty()) write_page(options, sets, table);
  flush_output();
}

[[nodiscard]] Json json_of(std::span<const analysis::ShadowedSet> sets) {
  Json json;
  json["trophic"] = trophic::version;
  for (const analysis::ShadowedSet& set : sets) {
    json["sets"].push_back(analysis::summary_json(set, analysis::summarize(set.ours.runs, set.shadow_runs())));
  }
  return json;
}

[[nodiscard]] std::vector<std::filesystem::path> folders(const std::vector<std::string>& names) {
  return {names.begin(), names.end()};
}

void measure(const Options& options) {
  const std::array sets{
      analysis::read_shadowed_set(folders(options.runs), options.shadow, options.until_s, options.accept_other_build)};
  const auto out = make_out(options);
  tell(sets[0]);
  std::ostringstream table;
  if (options.published) {
    analysis::print_claims(table, sets[0].ours, analysis::judge_claims(sets[0].ours.runs));
  } else {
    analysis::print_table(table, sets[0], analysis::summarize(sets[0].ours.runs, sets[0].shadow_runs()));
  }
  finish(options, out, sets, json_of(sets), table.str());
}

void compare(const Options& options) {
  const auto both = folders(options.compare);
  const auto read = [&](std::size_t i) {
    return analysis::read_shadowed_set(std::span{both}.subspan(i, 1), {}, options.until_s, options.accept_other_build);
  };
  std::array sets{read(0), read(1)};
  analysis::check_comparable(sets[0].ours.manifests.front(), sets[1].ours.manifests.front());
  if (sets[0].ours.label == sets[1].ours.label) {
    sets[0].ours.label += " (a)";
    sets[1].ours.label += " (b)";
  }
  const auto out = make_out(options);
  for (const analysis::ShadowedSet& set : sets) tell(set);
  const auto differences = analysis::compare_sets(sets[0], sets[1]);
  std::ostringstream table;
  analysis::print_differences(table, sets[0], sets[1], differences);
  Json json = json_of(sets);
  json["differences"] = analysis::differences_json(differences);
  finish(options, out, sets, json, table.str());
}

/// What can be known before anything is measured.
void check_page(const Options& options) {
  if (options.html.empty() && (!options.figures.empty() || options.replays)) {
    throw std::invalid_argument{"--figures and --replays: need --html"};
  }
  if (options.replays.value_or(0) > most_replays) {
    throw std::invalid_argument{"--replays " + std::to_string(*options.replays) + ": must be <= " + std::to_string(most_replays)};
  }
  if (options.html.empty()) return;
  check_new_file("--html", options.html);
  if (!options.figures.empty()) static_cast<void>(read_figures(options.figures));
}

void run(const Options& options) {
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
  check_page(options);
  const auto sweep = std::ranges::find_if(options.runs, [](const std::string& folder) { return analysis::is_sweep(folder); });
  if (sweep != options.runs.end()) {
    if (options.runs.size() > 1) throw std::invalid_argument{*sweep + ": is a sweep, which must be analyzed alone"};
    if (options.shadow || options.published)
      throw std::invalid_argument{*sweep + ": is a sweep: not with --shadow or --published"};
    if (!options.html.empty()) throw std::invalid_argument{*sweep + ": is a sweep: not with --html; name one of its cells"};
    measure_sweep(*sweep, options.out.value_or("analysis"), options.sweep, options.until_s, options.accept_other_build);
    return;
  }
  options.sweep.check_none();
  options.compare.empty() ? measure(options) : compare(options);
}

}  // namespace detail::analyze

/// Metrics of runs, claims about them, and differences between two sets of them.
Command analyze() {
  const auto options = std::make_shared<detail::analyze::Options>();
  return {
      .name = "analyze",
      .about =
          "Measures runs: the paper's metrics with 95 % intervals over runs, beside its published values and their nulls. The "
          "neutral shadow, runs in which nothing is inherited, is the null of every metric; it is found in RUNS/shadow. A "
          "sweep's "
          "cells are each compared with one of them, corrected for the number of comparisons.",
      .options =
          {{"runs", &options->runs,
            "folders of runs, or of replicates, pooled, so they must have one fingerprint; or one folder of a sweep"},
           {"--compare",
            &options->compare,
            "two such folders: the difference of every metric, raw and over their shadows",
            {},
            Words::suggested,
            2},
           {"--shadow", &options->shadow, "the runs' neutral shadow, where it is not in RUNS/shadow"},
           {"--until", &options->until_s, "measure only the first seconds of every run"},
           {"--accept-other-build", &options->accept_other_build,
            "pool runs that several builds of a program made, whose rules may be other code under the same names"},
           {"--published", &options->published,
            "a conclusion on every published claim, under each reading that the paper allows: reproduced, not reproduced or "
            "inconclusive"},
           {"--reference", &options->sweep.reference, "of a sweep: the cell that all others are compared with (the first)"},
           {"--metric", &options->sweep.metrics,
            "of a sweep: compare only these: METRIC, METRIC:SPECIES or METRIC:SPECIES:GROUP; fewer comparisons need fewer "
            "runs"},
           {"--difference", &options->sweep.difference,
            "of a sweep: how many replicates a difference of this size in --metric, in the tables' unit, would need"},
           {"--allow-missing", &options->sweep.allow_missing, "of a sweep: leave out runs that are missing or incomplete"},
           {"--jobs", &options->sweep.jobs, "of a sweep: runs measured at a time (1)"},
           {"--out", &options->out, "new folder for the tables and summary.json (analysis; with --html alone there are none)"},
           {"--html", &options->html, "new page with the table, figures and replays, which opens from disk"},
           {"--figures", &options->figures, "of the page: the folder of figures that plot.py made, with its captions.json"},
           {"--replays", &options->replays,
            "of the page: how many runs of a set it replays, at most 20 (2, where they were recorded)"}},
      .work =
          [options] {
            detail::analyze::run(*options);
            return 0;
          },
      .subcommands = {},
      .version = {}};
}

}  // namespace trophic::command
