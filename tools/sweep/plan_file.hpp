// SPDX-License-Identifier: MIT
// plan.jsonl: the runs of a sweep over a grid, one a line, for running and analysis.
#pragma once

#include <trophic/io/run_folder.hpp>
#include <trophic/support/json.hpp>

namespace trophic::sweep {

/// The file of a sweep's folder that lists its runs.
inline constexpr std::string_view plan_name = "plan.jsonl";

/// The setting of a run's length.
inline constexpr const char* duration_path = "ecology.duration_s";

/// One run of a sweep: a replicate of a cell of the grid, or of the cell's neutral shadow.
struct PlannedRun {
  std::size_t index = 0;      ///< its place in the plan, from 0
  std::size_t cell = 0;       ///< point of the grid
  std::size_t replicate = 0;  ///< of the cell
  bool shadow = false;        ///< of the cell's neutral shadow
  std::string rule_table;
  std::string engine;
  Json settings = Json::object();  ///< numbers, texts and switches by their paths
  std::uint64_t seed = 0;
  double until_s = 0.0;                        ///< > 0; simulated seconds
  io::OutputOptions output{.replay_hz = 0.0};  ///< how much of it is written
  double work = 0.0;                           ///< robots times steps of the engine, to begin with the longest
  std::filesystem::path folder;                ///< relative to the sweep's
  std::string fingerprint;                     ///< of the run, as its manifest has it
};

/// Reads a plan. Throws std::invalid_argument: "PATH: ..." for a file that cannot be read or lists nothing, and "PATH:LINE: FIELD
/// = VALUE: must ..." for a line that is not a JSON object, lacks a field or has a bad one. Lines stand in the order of their
/// `index`; folders lie within the sweep's and none is there twice; the runs of a cell have one rule table, engine, duration,
/// output, and one value of each setting, and distinct seeds; those that are not shadows have one
/// fingerprint, and its shadows have one; a replicate and its shadow have one seed.
[[nodiscard]] std::vector<PlannedRun> read_plan(const std::filesystem::path& path);

/// The text of a plan, which `read_plan` reads back.
[[nodiscard]] std::string plan_text(std::span<const PlannedRun> runs);

}  // namespace trophic::sweep
