// SPDX-License-Identifier: MIT
// `trophic analyze`, from runs to results: its options, and what the Python module needs of a program.
#include <cmath>
#include <cstdlib>
#include <memory>
#include <thread>
#include <tools/command/output.hpp>
#include <tools/command/run_python.hpp>
#include <tools/reading/pooled_runs.hpp>
#include <tools/trophic/analysis_tables.hpp>
#include <tools/trophic/analyze.hpp>
#include <tools/trophic/replay/page_parts.hpp>
#include <trophic/params/params.hpp>

namespace trophic::command {

namespace detail::analyze {

struct Options {
  std::vector<std::string> runs;
  std::vector<std::string> compare;
  std::optional<std::string> shadow;
  std::optional<double> until_s;
  std::vector<std::string> metrics;
  std::vector<std::string> columns;
  std::vector<std::string> metric_files;
  bool lineages = false;
  std::optional<double> window_s;
  bool bodies = false;
  std::vector<std::string> selection;
  bool accept_other_build = false;
  bool published = false;
  bool all = false;
  std::optional<std::uint64_t> reference;
  std::optional<double> difference;
  bool allow_missing = false;
  std::optional<std::uint64_t> jobs;
  std::optional<std::string> out;
  std::optional<std::string> html;
  std::optional<std::string> figures;
  std::optional<std::uint64_t> replays;
};

inline constexpr std::uint64_t most_replays = 20;

[[nodiscard]] std::filesystem::path temporary_folder() {
  std::string path = (std::filesystem::temp_directory_path() / "trophic-XXXXXX").string();
  if (::mkdtemp(path.data()) == nullptr) throw std::runtime_error{path + ": cannot make this temporary folder"};
  return path;
}

/// Checks what does not depend on the content of files.
void check(const Options& options) {
  const auto refuse = [](const std::string& why) { throw std::invalid_argument{why}; };
  if (options.runs.empty() == options.compare.empty()) refuse("either folders of runs, or --compare and two of them");
  if (options.jobs == std::uint64_t{0}) refuse("--jobs 0: must be >= 1");
  if (options.until_s && !(*options.until_s > 0.0 && std::isfinite(*options.until_s))) {
    refuse("--until " + number_text(*options.until_s) + ": must be > 0");
  }
  if (options.replays.value_or(0) > most_replays) {
    refuse("--replays " + std::to_string(*options.replays) + ": must be <= " + std::to_string(most_replays));
  }
  if (options.html) check_new_file("--html", *options.html);
  if (options.out) check_new_file("--out", *options.out);
  for (const std::string& folder : options.compare) {
    if (analysis::is_sweep(folder)) refuse("--compare " + folder + ": is a sweep; name two of its cells");
  }
  const auto sweep = std::ranges::find_if(options.runs, &analysis::is_sweep);
  if (sweep == options.runs.end()) {
    const auto only = [&](bool is_asked, const char* option) {
      if (is_asked) refuse(std::string{option} + ": only with a sweep, a folder with plan.jsonl");
    };
    only(options.reference.has_value(), "--reference");
    only(options.difference.has_value(), "--difference");
    only(options.allow_missing, "--allow-missing");
    return;
  }
  if (options.runs.size() > 1) refuse(*sweep + ": is a sweep, which must be analyzed alone");
  if (options.shadow || options.published) refuse(*sweep + ": is a sweep: not with --shadow or --published");
  if (options.html) refuse(*sweep + ": is a sweep: not with --html; name one of its cells");
  if (options.lineages || !options.selection.empty()) {
    refuse(*sweep + ": is a sweep: not with --lineages or --selection; name one of its cells");
  }
}

/// Checks, and adds to the request what only a program can make of runs, as files of a temporary folder.
void prepare(const Options& options, const Offer& offer, Json& request) {
  check(options);
  if (!options.runs.empty() && analysis::is_sweep(options.runs.front())) request["command"] = "analyze-sweep";
  if (!options.selection.empty()) request["command"] = "analyze-selection";
  if (!(options.lineages || options.bodies || options.html)) return;
  std::vector<std::vector<std::filesystem::path>> sets;
  if (!options.runs.empty()) sets.emplace_back(options.runs.begin(), options.runs.end());
  for (const std::string& folder : options.compare) sets.push_back({folder});
  const std::filesystem::path folder = temporary_folder();
  try {
    if (options.lineages) {
      write_signatures(folder / "signatures.csv",
                       {.folders = sets.front(), .shadow = options.shadow, .any_build = options.accept_other_build}, offer,
                       options.jobs.value_or(std::max(1U, std::thread::hardware_concurrency())));
      request["signatures"] = (folder / "signatures.csv").string();
    }
    if (options.bodies) {
      std::vector<std::filesystem::path> all;
      for (const auto& set : sets) all.insert(all.end(), set.begin(), set.end());
      if (options.shadow) all.emplace_back(*options.shadow);
      write_plan_distances(folder / "plan_distances.csv", all);
      request["plan_distances"] = (folder / "plan_distances.csv").string();
    }
    if (options.html) request["recordings"] = replay::write_parts(folder, sets, options.replays, request["who"]);
  } catch (...) {
    std::filesystem::remove_all(folder);
    throw;
  }
  request["temporary"] = folder.string();
}

}  // namespace detail::analyze

Command analyze(const std::string& program, const Offer& offer) {
  const auto options = std::make_shared<detail::analyze::Options>();
  Command command{
      .name = "analyze",
      .about =
          "Measures runs: the paper's metrics with 95 % intervals over runs, next to its published values and their nulls. The "
          "neutral shadow, runs in which nothing is inherited, is found in RUNS/shadow. Measures of genomes, bodies and brains "
          "are compared with the neutral null in RUNS/neutral, which --neutral makes, if there is one. Each cell of a sweep is "
          "compared with one of them, corrected for the number of comparisons. Needs Python with pandas, scipy and jinja2.",
      .options =
          {{"runs", &options->runs,
            "folders of runs, or of replicates, pooled, so they must have one fingerprint; or one folder of a sweep"},
           {.name = "--compare",
            .target = &options->compare,
            .help = "two such folders: the difference of every metric, raw and over their nulls",
            .values = 2,
            .not_with = {"--shadow", "--published"}},
           {"--shadow", &options->shadow, "the runs' neutral shadow, if it is not in RUNS/shadow"},
           {"--until", &options->until_s, "measure only the first seconds of every run"},
           {"--metric", &options->metrics,
            "test only these: METRIC, METRIC:SPECIES or METRIC:SPECIES:GROUP; fewer tests need fewer runs. `trophic help "
            "metrics` lists them"},
           {"--column", &options->columns,
            "a metric of your own: FILE:COLUMN or FILE:COLUMN:UNIT, a CSV table in each run's folder, of which the mean over "
            "rows is tested like any metric; may be repeated"},
           {"--metric-file", &options->metric_files,
            "metrics of your own: a Python file whose functions of a run are marked with @trophic.metric; may be repeated"},
           {.name = "--lineages",
            .target = &options->lineages,
            .help = "measure lineages instead: change, novelty, ecology and complexity of what persists, evolutionary activity "
                    "and descent, next to their nulls; docs/how-to/is-it-open-ended.md explains them",
            .not_with = {"--published", "--until", "--compare", "--column", "--metric-file"}},
           {.name = "--window",
            .target = &options->window_s,
            .help = "of --lineages: seconds for which a type must persist (500, or a quarter of shorter runs)",
            .needs = {"--lineages"}},
           {.name = "--bodies",
            .target = &options->bodies,
            .help = "measure bodies instead: shape, size, number of plans, genes of gaits and brains, and how fast robots walk; "
                    "selection needs the neutral null of the runs (--neutral)",
            .not_with = {"--published", "--lineages"}},
           {.name = "--selection",
            .target = &options->selection,
            .help = "measure instead where selection acts on a trait, by Price's equation: turns_to, open_speed, velocity_open, "
                    "gene:NUMBER or FILE:COLUMN:UNIT; may be repeated; docs/how-to/where-does-selection-act.md explains it",
            .not_with = {"--compare", "--published", "--lineages", "--bodies", "--metric", "--column", "--metric-file",
                         "--html"}},
           {"--accept-other-build", &options->accept_other_build,
            "pool runs that several builds of a program made, whose rules may be other code under the same names"},
           {.name = "--published",
            .target = &options->published,
            .help = "a conclusion on every published claim, under each reading that the paper allows: reproduced, not reproduced "
                    "or inconclusive",
            .not_with = {"--metric"}},
           {"--all", &options->all, "print every metric, not only the clearest findings"},
           {"--reference", &options->reference, "for a sweep: the cell that all others are compared with (the first)"},
           {"--difference", &options->difference,
            "for a sweep: how many replicates a difference of this size in --metric, in the tables' unit, would need"},
           {"--allow-missing", &options->allow_missing, "for a sweep: leave out runs that are missing or incomplete"},
           {"--jobs", &options->jobs, "runs measured at a time (one per core); results do not depend on it"},
           {"--out", &options->out,
            "new folder for the tables and summary.json (analysis, or the next free analysis-1, -2, ...; with --html alone there "
            "are none)"},
           {"--html", &options->html, "new page with the table, figures and replays, which opens from disk"},
           {.name = "--figures",
            .target = &options->figures,
            .help = "for the page: the folder of figures that `trophic plot` made, with its captions.json",
            .needs = {"--html"}},
           {.name = "--replays",
            .target = &options->replays,
            .help = "for the page: how many runs of a set it replays, at most 20 (2, if they were recorded)",
            .needs = {"--html"}}},
      .examples = {program + " analyze runs/paper --out analysis",
                   program + " analyze --compare runs/paper runs/released --metric velocity:predator",
                   program + " analyze runs/sweep --reference 3 --jobs 4"}};
  return python_command(program, std::move(command),
                        [options, offer](Json& request) { detail::analyze::prepare(*options, offer, request); });
}

}  // namespace trophic::command
