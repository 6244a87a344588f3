// SPDX-License-Identifier: MIT
// `trophic analyze` on a sweep: its cells against one of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <tools/analysis/data/sweep_runs.hpp>
#include <tools/analysis/metrics/sweep_values.hpp>
#include <trophic/support/json.hpp>
#include <vector>

namespace trophic::command::detail::analyze {

/// What `trophic analyze` is asked of a sweep alone.
struct SweepOptions {
  std::optional<std::uint64_t> reference;
  std::vector<std::string> metrics;
  std::optional<double> difference;
  bool allow_missing = false;
  std::optional<std::uint64_t> jobs;

  /// Throws std::invalid_argument if anything is asked, as of folders that are no sweep.
  void check_none() const;
  /// Throws std::invalid_argument for a number out of bounds, and for a difference of no metric.
  void check() const;
};

void write_json(const std::filesystem::path& path, const Json& json);

/// Everything that can be known of a sweep without measuring it. Throws std::invalid_argument.
void check_sweep(const analysis::SweepRuns& sweep, std::size_t reference, const SweepOptions& options,
                 std::optional<double> until_s);

/// Measures a sweep and writes what its cells differ in.
void measure_sweep(const std::filesystem::path& folder, const std::filesystem::path& out_folder, const SweepOptions& options,
                   std::optional<double> until_s, bool any_build);

}  // namespace trophic::command::detail::analyze
