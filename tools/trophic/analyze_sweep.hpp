// SPDX-License-Identifier: MIT
// `trophic analyze` on a sweep: its cells compared with one of them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <tools/analysis/data/sweep_runs.hpp>
#include <tools/analysis/metrics/sweep_values.hpp>
#include <trophic/support/json.hpp>
#include <vector>

namespace trophic::command::detail::analyze {

/// Options of `trophic analyze` that only a sweep has.
struct SweepOptions {
  std::optional<std::uint64_t> reference;
  std::optional<double> difference;
  bool allow_missing = false;
  std::string who;  ///< "trophic analyze", which begins a line on standard error

  /// Throws std::invalid_argument if anything is asked, for folders that are not a sweep.
  void check_none() const;
};

/// A folder for results that goes again if the analysis fails.
class ResultFolder {
 public:
  /// Makes it at once: `out`, or "analysis", "analysis-1", ... Throws std::invalid_argument for a folder that exists.
  explicit ResultFolder(const std::optional<std::string>& out);
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;
  ~ResultFolder();
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  void keep() { is_kept_ = true; }

 private:
  std::filesystem::path path_;
  bool is_kept_ = false;
};

/// Adds a progress line on a terminal: how many of `runs` runs are measured.
[[nodiscard]] analysis::Measuring with_progress(const analysis::Measuring& how, std::size_t runs);

void write_json(const std::filesystem::path& path, const Json& json);

/// Throws std::invalid_argument unless a run's folder has the files of all columns.
void check_columns(const std::filesystem::path& run, const analysis::Measuring& how);

/// Everything that can be known of a sweep without measuring it. Throws std::invalid_argument.
void check_sweep(const analysis::SweepRuns& sweep, std::size_t reference, const SweepOptions& options,
                 const analysis::Measuring& how);

/// Measures a sweep and writes what its cells differ in; `metrics`: see analysis::chosen.
void measure_sweep(const std::filesystem::path& folder, const std::optional<std::string>& out_folder, const SweepOptions& options,
                   const analysis::Measuring& how, const std::vector<std::string>& metrics);

}  // namespace trophic::command::detail::analyze
