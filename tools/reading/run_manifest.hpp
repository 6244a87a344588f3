// SPDX-License-Identifier: MIT
// The manifest of a run, as metrics need it.
#pragma once

#include <map>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/io/csv_file.hpp>
#include <trophic/support/json.hpp>

namespace trophic::analysis {

/// The entries of a run's manifest that metrics need.
struct RunManifest {
  std::filesystem::path folder;
  std::string fingerprint;
  std::string rules;
  std::string backend;
  std::string status;  ///< running (or killed), complete, stopped, failed
  std::uint64_t seed = 0;
  std::string begins;  ///< "at 700 s of runs/a (seed 7)", of a run that begins at a moment of another one; else empty
  std::pair<std::uint64_t, std::string>
      changes;                      ///< of parameters during the run: their number, and a text of them that runs share
  double until_s = 0.0;             ///< planned; after cut_to, what is left
  std::optional<double> reached_s;  ///< none for a run that was killed or is still running
  double half_side_m = 0.0;
  std::int64_t agents_every_ticks = 1;  ///< agents.csv has the ticks whose number is a multiple of it
  Json policies;                        ///< by slot
  Json params;
  FoodWeb web{{}, {}};
  std::map<std::string, io::TableSum> tables;  ///< by file name; empty for a run that was killed
  std::vector<std::string> builds;  ///< the codes of the programs that made it, sorted; see trophic/io/program_code.hpp
};

/// "0123456789abcdef and fedcba9876543210": the builds of a run, "an unknown build" if its manifest lists none.
[[nodiscard]] std::string builds_text(const std::vector<std::string>& builds);

/// When a run ended; none of one that was killed or is still running.
[[nodiscard]] std::optional<double> end_s(const RunManifest& run);

/// How a run ended and when, of how much.
[[nodiscard]] std::string lasted_text(const RunManifest& run);

/// Whether two runs are known to have lasted equally long, of the same time.
[[nodiscard]] bool lasted_alike(const RunManifest& a, const RunManifest& b);

/// The first value in which two objects differ, as "KEY = THAT OF b: must be THAT OF a", a's keys first; empty where none does.
[[nodiscard]] std::string first_difference(const Json& a, const Json& b);

/// Reads the text of a manifest; errors name it `path`. Throws std::runtime_error naming file and field.
[[nodiscard]] RunManifest manifest_of(std::string_view text, const std::filesystem::path& path);

/// Reads FOLDER/manifest.json and compares the run's files with it (checkpoint::damage_in). Errors as manifest_of.
[[nodiscard]] RunManifest read_manifest(const std::filesystem::path& folder);

}  // namespace trophic::analysis
