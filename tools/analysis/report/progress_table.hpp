// SPDX-License-Identifier: MIT
// Progress across generations for people and machines: contests.csv, progress.csv and a table on the terminal.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <span>
#include <tools/analysis/report/contest_progress.hpp>
#include <trophic/io/column.hpp>

namespace trophic::analysis {

/// progress.csv: one row per species, role, kind of opponents and period.
struct ProgressRow {
  Against against = Against::own;
  std::string species = {};
  std::string role = {};
  std::string opponent = {};
  Period period = Period::early;
  double from_s = 0.0;
  double to_s = 0.0;
  std::size_t runs = 0;
  std::optional<double> mean_s = {};
  std::optional<double> lower_s = {};
  std::optional<double> upper_s = {};
  std::size_t shadow_runs = 0;
  std::optional<double> shadow_s = {};
  std::optional<double> over_shadow_s = {};
  std::optional<double> over_shadow_lower_s = {};
  std::optional<double> over_shadow_upper_s = {};
  std::optional<double> p = {};
  std::optional<double> p_holm = {};

  static constexpr auto columns() {
    using io::column;
    using Row = ProgressRow;
    return std::tuple{
        column("against", &Row::against, "",
               "own: opponents from the same run (historical); others: of another replicate (global)"),
        column("species", &Row::species, "", "whose progress it is"),
        column("role", &Row::role, "", "hunter or victim"),
        column("opponent", &Row::opponent, "", "the species that it meets"),
        column("period", &Row::period, "", "early: up to the split; late: from there on"),
        column("from_s", &Row::from_s, "s", "the epoch at which the period begins"),
        column("to_s", &Row::to_s, "s", "the epoch at which it ends"),
        column("runs", &Row::runs, "", "replicates"),
        column("mean_s", &Row::mean_s, "s",
               "progress, mean over replicates: contact that much sooner (hunter) or later (victim)"),
        column("lower_s", &Row::lower_s, "s", "95 % interval of the mean; empty with fewer than six replicates"),
        column("upper_s", &Row::upper_s, "s", "its other end"),
        column("shadow_runs", &Row::shadow_runs, "", "replicates of the shadow; 0 without one"),
        column("shadow_s", &Row::shadow_s, "s", "the same of the neutral shadow"),
        column("over_shadow_s", &Row::over_shadow_s, "s", "mean_s - shadow_s"),
        column("over_shadow_lower_s", &Row::over_shadow_lower_s, "s", "95 % interval of that difference, uncorrected"),
        column("over_shadow_upper_s", &Row::over_shadow_upper_s, "s", "its other end"),
        column("p", &Row::p, "", "of that difference, two-sided"),
        column("p_holm", &Row::p_holm, "", "corrected for both roles of a link, period and kind of opponents (Holm)")};
  }
};

/// Throw std::runtime_error if the file exists or cannot be written.
void write_contests(const std::filesystem::path& path, std::span<const ContestRow> contests);
void write_progress(const std::filesystem::path& path, std::span<const Progress> progress);

/// One line for each; says how many runs a test needs if there are too few.
void print_progress(std::ostream& out, std::span<const Progress> progress);

}  // namespace trophic::analysis
