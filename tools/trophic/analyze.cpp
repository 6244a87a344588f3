// SPDX-License-Identifier: MIT
// `trophic analyze`, from runs to results: metrics with intervals next to the paper's values and their nulls.
#include "commands.hpp"

#include <cmath>
#include <sstream>
#include <tools/analysis/metrics/body_metrics.hpp>
#include <tools/analysis/metrics/run_set.hpp>
#include <tools/analysis/metrics/sweep_values.hpp>
#include <tools/analysis/report/claim_conclusion.hpp>
#include <tools/analysis/report/claims_text.hpp>
#include <tools/analysis/report/compare_sets.hpp>
#include <tools/analysis/report/means_table.hpp>
#include <tools/analysis/report/metrics_table.hpp>
#include <tools/analysis/report/summary.hpp>
#include <tools/analysis/report/summary_json.hpp>
#include <tools/analysis/report/text_table.hpp>
#include <tools/command/option.hpp>
#include <tools/command/output.hpp>
#include <tools/contest/play_contests.hpp>
#include <tools/reading/lineages.hpp>
#include <tools/reading/met_inputs.hpp>
#include <tools/reading/shadow.hpp>
#include <tools/trophic/analysis_page.hpp>
#include <tools/trophic/analysis_words.hpp>
#include <tools/trophic/analyze_sweep.hpp>
#include <tools/trophic/replay/page.hpp>
#include <tools/trophic/replay/recorded_run.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/new_file.hpp>
#include <trophic/support/version.hpp>

namespace trophic::command {

namespace detail::analyze {

struct Options {
  std::string program;
  Offer offer;  ///< the rule tables of the program
  bool lineages = false;
  bool bodies = false;
  std::optional<double> window_s;
  std::vector<std::string> runs;
  std::vector<std::string> compare;
  std::optional<std::string> shadow;
  std::optional<double> until_s;
  bool published = false;
  bool all = false;
  std::vector<std::string> metrics;
  std::vector<std::string> columns;
  std::optional<std::uint64_t> jobs;
  bool accept_other_build = false;
  SweepOptions sweep;
  std::optional<std::string> out;
  std::string html;
  std::string figures;
  std::optional<std::uint64_t> replays;
};

inline constexpr std::uint64_t default_replays = 2;
inline constexpr std::uint64_t most_replays = 20;

/// The folder for tables: --out, else "analysis" or the next free one; null if only a page is asked for.
[[nodiscard]] std::unique_ptr<ResultFolder> make_out(const Options& options) {
  if (!options.out && !options.html.empty()) return nullptr;
  return std::make_unique<ResultFolder>(options.out);
}

void print_remarks(const Options& options, const analysis::ShadowedSet& set) {
  for (const std::string& remark : set.ours.remarks) std::cerr << options.sweep.who << ": " << remark << "\n";
  if (!set.shadow) return;
  for (const std::string& remark : set.shadow->remarks) std::cerr << options.sweep.who << ": " << remark << "\n";
}

/// The first runs of the sets as a viewer shows them; what cannot be shown is reported.
[[nodiscard]] std::vector<AnalysisPage::Replay> replays_of(const Options& options, std::span<const analysis::ShadowedSet> sets) {
  std::vector<AnalysisPage::Replay> replays;
  const std::uint64_t most = options.replays.value_or(default_replays);
  try {
    if (most > 0) static_cast<void>(replay::viewer_page());
    for (const analysis::ShadowedSet& set : sets) {
      for (std::size_t i = 0; i < std::min<std::size_t>(most, set.ours.manifests.size()); ++i) {
        const std::filesystem::path& folder = set.ours.manifests[i].folder;
        const std::vector<replay::RecordedRun> runs{replay::open_run(folder)};
        for (const std::string& remark : runs[0].remarks) std::cerr << options.sweep.who << ": " << remark << "\n";
        const std::string name = folder.lexically_normal().filename().string();
        replays.push_back({.label = sets.size() > 1 ? set.ours.label + " " + name : name, .part = replay::runs_part(runs, {})});
      }
    }
  } catch (const std::invalid_argument& error) {
    if (options.replays) throw;
    std::cerr << options.sweep.who << ": no replays: " << error.what() << "\n";
    replays.clear();
  }
  return replays;
}

/// The command line that makes the page of these runs.
[[nodiscard]] std::string command_of(const Options& options) {
  std::string command = options.program + " analyze";
  for (const std::string& folder : options.runs) command += " " + folder;
  if (!options.compare.empty()) command += " --compare " + options.compare[0] + " " + options.compare[1];
  if (options.shadow) command += " --shadow " + *options.shadow;
  if (options.until_s) command += " --until " + number_text(*options.until_s);
  if (options.lineages) command += " --lineages";
  if (options.bodies) command += " --bodies";
  if (options.window_s) command += " --window " + number_text(*options.window_s);
  if (options.published) command += " --published";
  if (!options.figures.empty()) command += " --figures " + options.figures;
  return command + " --html " + options.html;
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
  describe(page, sets, command_of(options));
  const std::string html = html_of(page);
  write_new_file(options.html, html);
  std::cout << "page    " << options.html << ": " << page.figures.size() << " figures, " << page.replays.size() << " replays, "
            << megabytes_text(html.size()) << "\n";
}

/// Results for the screen, for tables and for the page.
struct Results {
  std::vector<analysis::SummarizedSet> sets;
  std::vector<analysis::SetDifference> differences = {};  ///< of two sets that are compared
  std::string shown;                                      ///< on the screen
  std::string whole;                                      ///< on the page
};

void write_tables(const Options& options, const std::filesystem::path& out, std::span<const analysis::ShadowedSet> sets,
                  const Results& results) {
  std::string names = "metrics.csv,means.csv,means.tex";
  analysis::write_metrics(out / "metrics.csv", sets);
  analysis::write_means(out / "means.csv", results.sets);
  std::string tex;
  for (const analysis::SummarizedSet& set : results.sets) tex += analysis::means_tex(set);
  write_new_file(out / "means.tex", tex);
  Json json;
  json["trophic"] = trophic::version;
  for (const analysis::SummarizedSet& set : results.sets) json["sets"].push_back(analysis::summary_json(*set.set, set.rows));
  if (!options.compare.empty()) {
    json["differences"] = analysis::differences_json(results.differences);
    analysis::write_differences(out / "differences.csv", results.differences);
    write_new_file(out / "differences.tex", analysis::differences_tex(sets[0], sets[1], results.differences));
    names += ",differences.csv,differences.tex";
  }
  write_json(out / "summary.json", json);
  std::cout << "files   " << out.string() << "/{" << names << ",summary.json}\n";
}

void finish(const Options& options, ResultFolder* out, std::span<const analysis::ShadowedSet> sets, const Results& results) {
  std::cout << results.shown;
  if (out != nullptr) {
    write_tables(options, out->path(), sets, results);
    out->keep();
  }
  if (!options.html.empty()) write_page(options, sets, results.whole);
  flush_output();
}

[[nodiscard]] std::vector<std::filesystem::path> folders(const std::vector<std::string>& names) {
  return {names.begin(), names.end()};
}

[[nodiscard]] analysis::Measuring measuring_of(const Options& options) {
  analysis::Measuring how{.until_s = options.until_s,
                          .any_build = options.accept_other_build,
                          .columns = {},
                          .metrics = options.offer.metrics,
                          .bodies = options.bodies,
                          .jobs = options.jobs.value_or(1),
                          .on_run = {}};
  for (const std::string& column : options.columns) how.columns.push_back(analysis::own_column_of(column));
  return how;
}

/// Asks the brain of a run's rule table. Throws std::invalid_argument if the program does not have that table as it was.
[[nodiscard]] analysis::Decide brain_of(const analysis::RunManifest& run, const Offer& offer) {
  const contest::Plan plan{.rule_table = run.rules,
                           .engine = run.backend.substr(0, run.backend.find(' ')),
                           .fingerprint = run.fingerprint,
                           .params = run.params};
  if (const std::string why = why_not_played(plan, offer, "analyze them with the program that made them"); !why.empty()) {
    throw std::invalid_argument{run.folder.string() + ": " + why};
  }
  return experiment_of(plan, offer)->brain();
}

/// How the lineages of runs are measured, which must be checked. Signatures have inputs that were met in the first run and the
/// first one of the shadow.
[[nodiscard]] analysis::LineageMeasuring lineages_of(const std::vector<analysis::PooledRuns>& sets, const Options& options) {
  const analysis::RunManifest& first = sets.front().manifests.front();
  std::vector<analysis::RunManifest> met;
  for (const analysis::PooledRuns& set : sets) {
    for (const analysis::RunManifest& run : set.manifests) analysis::check_lineages(run);
    met.push_back(set.manifests.front());
  }
  const double window_s = options.window_s.value_or(analysis::default_window_s(*first.reached_s));
  for (const analysis::PooledRuns& set : sets) {
    for (const analysis::RunManifest& run : set.manifests) analysis::check_window(window_s, *run.reached_s);
  }
  const analysis::Decide brain = brain_of(first, options.offer);
  return {.decide = [brain](const analysis::RunManifest&) { return brain; },
          .inputs = analysis::met_inputs(met, analysis::signature_inputs),
          .window_s = window_s};
}

/// Checks, before anything is measured, that runs may be pooled, that metrics exist, and that each run has the wanted columns.
/// With --lineages adds to `how` what it takes from the runs. Returns the number of runs.
[[nodiscard]] std::size_t check_runs(std::span<const std::filesystem::path> paths, const std::optional<std::string>& shadow,
                                     const Options& options, analysis::Measuring& how) {
  std::vector<analysis::PooledRuns> all{analysis::pooled_runs(paths, how.until_s.has_value(), how.any_build)};
  const auto shadows = shadow ? std::vector<std::filesystem::path>{*shadow} : analysis::shadow_folders(paths);
  if (!shadows.empty()) {
    all.push_back(analysis::pooled_runs(shadows, how.until_s.has_value(), how.any_build));
    analysis::check_shadow(all[0].manifests.front(), all[1].manifests.front());
  }
  std::size_t runs = 0;
  for (const analysis::PooledRuns& pooled : all) {
    runs += pooled.manifests.size();
    for (const analysis::RunManifest& manifest : pooled.manifests) check_columns(manifest.folder, how);
  }
  if (options.lineages) how.lineages = lineages_of(all, options);
  if (options.bodies) {
    for (const analysis::PooledRuns& pooled : all) {
      for (const analysis::RunManifest& manifest : pooled.manifests) analysis::check_bodies(manifest.folder);
    }
  }
  analysis::check_names({&all[0].manifests.front().web, 1}, how, options.metrics);
  return runs;
}

template <class Print>
[[nodiscard]] std::string printed(Print&& print) {
  std::ostringstream text;
  print(text);
  return text.str();
}

void measure(const Options& options) {
  analysis::Measuring how = measuring_of(options);
  const auto paths = folders(options.runs);
  const std::size_t runs = check_runs(paths, options.shadow, options, how);
  const auto out = make_out(options);
  const std::array sets{analysis::read_shadowed_set(paths, options.shadow, with_progress(how, runs))};
  print_remarks(options, sets[0]);
  Results results{.sets = {{&sets[0], analysis::summarize(sets[0].ours.runs, sets[0].shadow_runs(), options.metrics)}},
                  .shown = {},
                  .whole = {}};
  const auto& rows = results.sets[0].rows;
  if (options.published) {
    results.whole =
        printed([&](auto& text) { analysis::print_claims(text, sets[0].ours, analysis::judge_claims(sets[0].ours.runs)); });
    results.shown = results.whole;
  } else {
    results.whole = printed([&](auto& text) { analysis::print_table(text, sets[0], rows); });
    const bool is_brief = !options.all && options.metrics.empty();
    results.shown = is_brief ? printed([&](auto& text) { analysis::print_findings(text, sets[0], rows); }) : results.whole;
  }
  finish(options, out.get(), sets, results);
}

void compare(const Options& options) {
  analysis::Measuring how = measuring_of(options);
  const auto both = folders(options.compare);
  const auto one = [&](std::size_t i) { return std::span{both}.subspan(i, 1); };
  const std::size_t runs = check_runs(one(0), {}, options, how) + check_runs(one(1), {}, options, how);
  if (!how.until_s) {
    analysis::check_comparable(analysis::pooled_runs(one(0), false, how.any_build).manifests.front(),
                               analysis::pooled_runs(one(1), false, how.any_build).manifests.front());
  }
  const auto out = make_out(options);
  const analysis::Measuring shown = with_progress(how, runs);
  std::array sets{analysis::read_shadowed_set(one(0), {}, shown), analysis::read_shadowed_set(one(1), {}, shown)};
  analysis::check_comparable(sets[0].ours.manifests.front(), sets[1].ours.manifests.front());
  if (sets[0].ours.label == sets[1].ours.label) {
    sets[0].ours.label += " (a)";
    sets[1].ours.label += " (b)";
  }
  for (const analysis::ShadowedSet& set : sets) print_remarks(options, set);
  Results results{.sets = {}, .differences = analysis::compare_sets(sets[0], sets[1], options.metrics), .shown = {}, .whole = {}};
  for (const analysis::ShadowedSet& set : sets) {
    results.sets.push_back({&set, analysis::summarize(set.ours.runs, set.shadow_runs(), options.metrics)});
  }
  results.whole = printed([&](auto& text) { analysis::print_differences(text, sets[0], sets[1], results.differences); });
  results.shown = options.all || !options.metrics.empty() ? results.whole : printed([&](auto& text) {
    analysis::print_difference_findings(text, sets[0], sets[1], results.differences);
  });
  finish(options, out.get(), sets, results);
}

/// Checks the options of the page before anything is measured.
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
  if (options.published && !options.metrics.empty()) {
    throw std::invalid_argument{"--metric: not with --published, which has a list of its own"};
  }
  if (options.window_s && !options.lineages) throw std::invalid_argument{"--window: needs --lineages"};
  if (options.lineages && (options.published || options.until_s || !options.compare.empty() || !options.columns.empty())) {
    throw std::invalid_argument{"--lineages: not with --published, --until, --compare or --column"};
  }
  if (options.bodies && (options.published || options.lineages)) {
    throw std::invalid_argument{"--bodies: not with --published or --lineages"};
  }
  if (options.jobs == std::uint64_t{0}) throw std::invalid_argument{"--jobs 0: must be >= 1"};
  if (options.until_s && !(*options.until_s > 0.0 && std::isfinite(*options.until_s))) {
    throw std::invalid_argument{"--until " + number_text(*options.until_s) + ": must be > 0"};
  }
  for (const std::string& folder : options.compare) {
    if (analysis::is_sweep(folder)) throw std::invalid_argument{"--compare " + folder + ": is a sweep; name two of its cells"};
  }
  check_page(options);
  const auto sweep = std::ranges::find_if(options.runs, [](const std::string& folder) { return analysis::is_sweep(folder); });
  if (sweep != options.runs.end()) {
    if (options.runs.size() > 1) throw std::invalid_argument{*sweep + ": is a sweep, which must be analyzed alone"};
    if (options.shadow || options.published)
      throw std::invalid_argument{*sweep + ": is a sweep: not with --shadow or --published"};
    if (!options.html.empty()) throw std::invalid_argument{*sweep + ": is a sweep: not with --html; name one of its cells"};
    if (options.lineages) throw std::invalid_argument{*sweep + ": is a sweep: not with --lineages; name one of its cells"};
    measure_sweep(*sweep, options.out, options.sweep, measuring_of(options), options.metrics);
    return;
  }
  options.sweep.check_none();
  options.compare.empty() ? measure(options) : compare(options);
}

}  // namespace detail::analyze

Command analyze(const std::string& program, const Offer& offer) {
  const auto options = std::make_shared<detail::analyze::Options>();
  const FoodWeb any_web{{"prey", "predator"}, {{1, 0}}};
  analysis::check_names({&any_web, 1}, {.metrics = offer.metrics}, {});
  options->program = program;
  options->sweep.who = program + " analyze";
  options->offer = offer;
  return {
      .name = "analyze",
      .about =
          "Measures runs: the paper's metrics with 95 % intervals over runs, next to its published values and their nulls. The "
          "neutral shadow, runs in which nothing is inherited, is the null of every metric; it is found in RUNS/shadow. Each "
          "cell "
          "of a sweep is compared with one of them, corrected for the number of comparisons.",
      .options =
          {{"runs", &options->runs,
            "folders of runs, or of replicates, pooled, so they must have one fingerprint; or one folder of a sweep"},
           {"--compare",
            &options->compare,
            "two such folders: the difference of every metric, raw and over their shadows",
            {},
            2},
           {"--shadow", &options->shadow, "the runs' neutral shadow, if it is not in RUNS/shadow"},
           {"--until", &options->until_s, "measure only the first seconds of every run"},
           {"--metric", &options->metrics,
            "test only these: METRIC, METRIC:SPECIES or METRIC:SPECIES:GROUP; fewer tests need fewer runs. `trophic help "
            "metrics` "
            "lists them"},
           {"--column", &options->columns,
            "a metric of your own: FILE:COLUMN or FILE:COLUMN:UNIT, a CSV table in each run's folder, of which the mean over "
            "rows "
            "is tested like any metric; may be repeated"},
           {"--lineages", &options->lineages,
            "measure lineages instead: change, novelty, ecology and complexity of what persists, evolutionary activity and "
            "descent, next to the shadow and to drift; docs/how-to/is-it-open-ended.md explains them"},
           {"--window", &options->window_s,
            "of --lineages: seconds for which a type must persist (500, or a quarter of shorter runs)"},
           {"--bodies", &options->bodies,
            "measure bodies instead: shape, size, number of plans, genes of gaits and brains, and how fast robots walk; for "
            "drift, --compare with runs whose parents are drawn at random"},
           {"--accept-other-build", &options->accept_other_build,
            "pool runs that several builds of a program made, whose rules may be other code under the same names"},
           {"--published", &options->published,
            "a conclusion on every published claim, under each reading that the paper allows: reproduced, not reproduced or "
            "inconclusive"},
           {"--all", &options->all, "print every metric, not only the clearest findings"},
           {"--reference", &options->sweep.reference, "for a sweep: the cell that all others are compared with (the first)"},
           {"--difference", &options->sweep.difference,
            "for a sweep: how many replicates a difference of this size in --metric, in the tables' unit, would need"},
           {"--allow-missing", &options->sweep.allow_missing, "for a sweep: leave out runs that are missing or incomplete"},
           {"--jobs", &options->jobs, "runs measured at a time (1); results do not depend on it"},
           {"--out", &options->out,
            "new folder for the tables and summary.json (analysis, or the next free analysis-1, -2, ...; with --html alone there "
            "are "
            "none)"},
           {"--html", &options->html, "new page with the table, figures and replays, which opens from disk"},
           {"--figures", &options->figures,
            "for the page: the folder of figures that `trophic plot` made, with its captions.json"},
           {"--replays", &options->replays,
            "for the page: how many runs of a set it replays, at most 20 (2, if they were recorded)"}},
      .work =
          [options] {
            detail::analyze::run(*options);
            return 0;
          },
      .subcommands = {},
      .version = {},
      .examples = {program + " analyze runs/paper --out analysis",
                   program + " analyze --compare runs/paper runs/released --metric velocity:predator",
                   program + " analyze runs/sweep --reference 3 --jobs 4"}};
}

}  // namespace trophic::command
