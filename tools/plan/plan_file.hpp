// SPDX-License-Identifier: MIT
// plan.jsonl: a list of runs, one a line, which a program runs and Python analyses.
#pragma once

#include <trophic/io/run_folder.hpp>
#include <trophic/population/null.hpp>
#include <trophic/support/json.hpp>

namespace trophic::plan {

/// One run of a plan.
struct PlannedRun {
  std::string rule_table;
  std::string engine;
  Json settings = Json::object();  ///< parameters by their paths
  std::uint64_t seed = 0;
  Null null = Null::none;
  std::filesystem::path folder;                ///< relative to the plan's
  io::OutputOptions output{.replay_hz = 0.0};  ///< how much of it is written
  // As the program describes the run; empty in a draft.
  double until_s = 0.0;     ///< simulated seconds
  double work = 0.0;        ///< robots times steps of the engine, to begin with the longest
  std::string fingerprint;  ///< as its manifest has it
};

/// Drafts are described by `PROGRAM --plan DRAFT --describe`; only described runs can be made. A draft without rule_table or
/// engine has the program's default.
enum class Lines { described, drafts };

/// Reads a plan. Throws std::invalid_argument: "PATH: ..." for a file that cannot be read or lists nothing, and "PATH:LINE: FIELD
/// = VALUE: must ..." for a line that is not a JSON object, lacks a field, or has a bad or unknown one. Folders lie within the
/// plan's, and each is there once. `cell`, `replicate` and `species` are for those who make plans and are not read.
[[nodiscard]] std::vector<PlannedRun> read_plan(const std::filesystem::path& path, Lines lines = Lines::described);

/// "PATH:LINE: ", the beginning of an error about a run. `index`: its place in the plan, from 0.
[[nodiscard]] std::string place_of(const std::filesystem::path& path, std::size_t index);

}  // namespace trophic::plan
