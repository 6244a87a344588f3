// SPDX-License-Identifier: MIT
// Definitions of analyze_sweep.hpp.
#include <tools/trophic/analyze_sweep.hpp>

#include <cmath>
#include <cstdio>
#include <set>
#include <system_error>
#include <tools/analysis/metrics/metric_choice.hpp>
#include <tools/analysis/metrics/run_metrics.hpp>
#include <tools/analysis/report/axis_effects.hpp>
#include <tools/analysis/report/axis_rows.hpp>
#include <tools/analysis/report/cell_differences.hpp>
#include <tools/analysis/report/sweep_json.hpp>
#include <tools/analysis/report/sweep_tables.hpp>
#include <tools/analysis/report/sweep_text.hpp>
#include <tools/command/output.hpp>
#include <trophic/io/next_free_folder.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/observe/terminal.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/new_file.hpp>
#include <trophic/support/version.hpp>

namespace trophic::command::detail::analyze {

void SweepOptions::check_none() const {
  const auto refuse = [](bool is_asked, const char* option) {
    if (is_asked) throw std::invalid_argument{std::string{option} + ": only with a sweep, a folder with plan.jsonl"};
  };
  refuse(reference.has_value(), "--reference");
  refuse(difference.has_value(), "--difference");
  refuse(allow_missing, "--allow-missing");
}

ResultFolder::ResultFolder(const std::optional<std::string>& out) {
  const std::filesystem::path usual = "analysis";
  const bool is_taken = std::filesystem::exists(std::filesystem::symlink_status(usual));
  path_ = io::make_new_folder(out ? std::filesystem::path{*out} : is_taken ? io::next_free_folder(usual) : usual);
}

ResultFolder::~ResultFolder() {
  if (is_kept_) return;
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

analysis::Measuring with_progress(const analysis::Measuring& how, std::size_t runs) {
  analysis::Measuring shown = how;
  if (!observe::stderr_is_terminal()) return shown;
  const auto done = std::make_shared<std::size_t>(0);
  shown.on_run = [done, runs] {
    const bool is_last = ++*done == runs;
    std::fputs(
        ("\rmeasured " + std::to_string(*done) + " of " + std::to_string(runs) + " runs" + (is_last ? "\r\033[K" : "\033[K"))
            .c_str(),
        stderr);
    std::fflush(stderr);
  };
  return shown;
}

/// Prints the first few; a sweep has hundreds of runs.
void print_remarks(const std::string& who, const std::vector<std::string>& remarks) {
  constexpr std::size_t most = 5;
  for (std::size_t i = 0; i < std::min(most, remarks.size()); ++i) std::cerr << who << ": " << remarks[i] << "\n";
  if (remarks.size() > most) std::cerr << who << ": and " << remarks.size() - most << " more\n";
}

void write_json(const std::filesystem::path& path, const Json& json) {
  write_new_file(path, json_text(json, 2) + '\n');
}

void check_columns(const std::filesystem::path& run, const analysis::Measuring& how) {
  for (const analysis::OwnColumn& column : how.columns) {
    if (std::filesystem::exists(run / column.file)) continue;
    throw std::invalid_argument{"--column " + column.file + ":" + column.column + ": " + run.string() + " has no such file"};
  }
}

void check_sweep(const analysis::SweepRuns& sweep, std::size_t reference, const SweepOptions& options,
                 const analysis::Measuring& how) {
  const std::optional<double> until_s = how.until_s;
  const analysis::GridCell* base = sweep.grid.find(reference);
  if (base == nullptr) {
    throw std::invalid_argument{"--reference " + std::to_string(reference) + ": must be a cell of the sweep, " +
                                std::to_string(sweep.grid.cells.front().number) + " to " +
                                std::to_string(sweep.grid.cells.back().number)};
  }
  for (const analysis::GridCell& cell : sweep.grid.cells) static_cast<void>(analysis::is_paired(*base, cell));
  const double first_s = sweep.plan.front().until_s;
  for (const sweep::PlannedRun& run : sweep.plan) {
    const std::string here = sweep.folder_of(run.index).string() + ": " + number_text(run.until_s) + " s";
    if (until_s && run.until_s < *until_s)
      throw std::invalid_argument{here + ": must be >= " + number_text(*until_s) + " s, as --until asks"};
    if (!until_s && run.until_s != first_s) {
      throw std::invalid_argument{here + ", but " + sweep.folder_of(0).string() + " has " + number_text(first_s) +
                                  " s; runs of different length are not compared: use --until"};
    }
  }
  if (!sweep.missing.empty() && !options.allow_missing) {
    throw std::invalid_argument{sweep.folder.string() + ": " + analysis::missing_line(sweep) +
                                " (--allow-missing leaves them out)"};
  }
  for (std::size_t i = 0; i < sweep.plan.size(); ++i) {
    if (sweep.is_there[i]) check_columns(sweep.folder_of(i), how);
  }
  if (analysis::detail::runs_there(sweep, *base, &analysis::GridReplicate::run) == 0) {
    throw std::invalid_argument{"--reference " + std::to_string(reference) + ": must be a cell with a complete run"};
  }
}

void measure_sweep(const std::filesystem::path& folder, const std::optional<std::string>& out_folder, const SweepOptions& options,
                   const analysis::Measuring& how, const std::vector<std::string>& metrics) {
  if (options.difference && !(std::isfinite(*options.difference) && *options.difference > 0.0)) {
    throw std::invalid_argument{"--difference " + number_text(*options.difference) + ": must be > 0"};
  }
  if (options.difference && metrics.empty())
    throw std::invalid_argument{"--difference: needs --metric, which names what is to differ"};
  const analysis::SweepRuns sweep = analysis::read_sweep(folder, how.any_build);
  const auto reference = static_cast<std::size_t>(options.reference.value_or(sweep.grid.cells.front().number));
  check_sweep(sweep, reference, options, how);
  std::set<std::int64_t> thinnings;
  for (const sweep::PlannedRun& run : sweep.plan) thinnings.insert(run.output.agents_every_ticks);
  for (const std::int64_t every : thinnings) {
    if (const std::string lost = analysis::lost_to_thinning(every); !lost.empty())
      std::cerr << options.who << ": " << lost << "\n";
  }
  analysis::check_names(sweep.webs, how, metrics);
  ResultFolder result{out_folder};
  const std::filesystem::path& out = result.path();
  const auto there = static_cast<std::size_t>(std::ranges::count(sweep.is_there, true));
  const analysis::SweepValues values = analysis::measure_sweep(sweep, with_progress(how, there));
  const auto names = metrics.empty() ? analysis::distinct_metrics(values) : analysis::chosen(values.names, metrics);
  const std::optional<double> until_s = how.until_s;
  if (sweep.builds.size() > 1) {
    std::cerr << options.who << ": " << sweep.builds.size()
              << " builds of a program made these runs: " << analysis::builds_text(sweep.builds)
              << "; their rules may be other code under the same names\n";
  }
  if (!sweep.missing.empty()) std::cerr << options.who << ": " << analysis::missing_line(sweep) << "; left out\n";
  print_remarks(options.who, values.remarks);
  const auto differences = analysis::compare_cells(sweep.grid, values, reference, names);
  std::vector<analysis::RunsForDifference> answers;
  if (options.difference) answers = analysis::runs_for_difference(differences, *options.difference);

  analysis::print_sweep(std::cout, sweep, differences, reference, until_s);
  if (const std::size_t repeats = values.names.size() - names.size(); metrics.empty() && repeats > 0) {
    std::cout << "metrics " << names.size() << "; " << repeats
              << " more repeat one of them, and are compared if --metric names them\n";
  }
  analysis::print_cell_differences(std::cout, sweep.grid, differences);
  if (!metrics.empty()) analysis::print_named_metrics(std::cout, sweep.grid, differences);
  const auto effects = analysis::axis_effects(sweep.grid, values, reference, names);
  analysis::print_axis_effects(std::cout, effects);
  analysis::print_runs_for_difference(std::cout, answers, differences);
  analysis::write_cells(out / "cells.csv", sweep, until_s);
  analysis::write_runs(out / "runs.csv", sweep, values);
  analysis::write_sweep_metrics(out / "sweep_metrics.csv", sweep.grid, values);
  analysis::write_sweep_differences(out / "sweep_differences.csv", differences, reference);
  analysis::write_axis_effects(out / "sweep_effects.csv", effects);
  Json json{{"trophic", trophic::version}};
  json["sweep"] = analysis::sweep_json(sweep, differences, reference, answers);
  write_json(out / "summary.json", json);
  std::cout << "files   " << out.string()
            << "/{cells.csv,runs.csv,sweep_metrics.csv,sweep_differences.csv,sweep_effects.csv,summary.json}\n";
  result.keep();
  flush_output();
}

}  // namespace trophic::command::detail::analyze
