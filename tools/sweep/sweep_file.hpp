// SPDX-License-Identifier: MIT
// sweep.toml: the settings that a study tries, and the number of replicates.
#pragma once

#include <trophic/io/run_folder.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/json.hpp>

namespace trophic::sweep {

/// Paths of parameters ("rules.capture.reach_m"), "rule_table" and "engine", with their values, in the order of the file. An
/// object.
using Settings = Json;

/// One key with the values that are tried.
struct Axis {
  std::string key;
  std::vector<Json> values;
};

/// More than this is a typing error.
inline constexpr std::size_t most_runs = 1'000'000;

/// A file as
///
///     rule_table = "paper"           # the program's first, if it is not given
///     engine = "kinematic"           # the program's default
///     replicates = 10                # runs of each cell
///     seed = 1                       # the seeds of all runs follow from it
///     paired = true                  # replicate k has the same seed in every cell
///     shadow = false                 # each run's neutral shadow, too
///     replay_hz = 0.0                # frames of each run's recording in a simulated second: 0, 5, 10 or 30
///     agents_every = 1               # each agents.csv has the ticks whose number is a multiple of it
///     senses = false                 # each run's senses.csv, too
///     states = false                 # each run's states.csv, too
///     [set]                          # in every run
///     ecology.duration_s = 3000.0
///     [grid]                         # every value with every other
///     rules.capture.reach_m = [0.5, 1.0]
///     [zip]                          # lists of one length: the first values together, then the second, ...
///     rules.floor.floor = [6, 7]
///     rules.minimum_predators.below = [6, 7]
///     [[runs]]                       # settings that belong together
///     rule_table = "released"
struct SweepFile {
  /// The keys that are not settings of a run.
  struct Params {
    std::uint64_t replicates = 10;
    std::uint64_t seed = 1;
    bool paired = true;
    bool shadow = false;
    double replay_hz = 0.0;
    std::int64_t agents_every = 1;
    bool senses = false;
    bool states = false;

    static constexpr auto fields() {
      return std::tuple{
          field("replicates", &Params::replicates, between(1.0, static_cast<double>(most_runs)), "runs of each cell"),
          field("seed", &Params::seed, any_seed(), "the seeds of all runs follow from it"),
          field("paired", &Params::paired, "replicate k has the same seed in every cell"),
          field("shadow", &Params::shadow, "each run's neutral shadow, too"),
          field("replay_hz", &Params::replay_hz, between(0.0, 30.0), "frames of the recording in a simulated second"),
          field("agents_every", &Params::agents_every, between(1.0, 1e6), "ticks from one to the next in agents.csv"),
          field("senses", &Params::senses, "each run's senses.csv, too"),
          field("states", &Params::states, "each run's states.csv, too")};
    }
    [[nodiscard]] io::OutputOptions output() const { return {replay_hz, agents_every, senses, states}; }
  };

  std::filesystem::path path;
  std::string text;
  Params params;
  Settings set = Settings::object();
  std::vector<Axis> grid;
  std::vector<Axis> zip;
  std::vector<Settings> runs;
};

/// Reads a sweep. Throws std::invalid_argument "FILE: ..." for a bad file: an unknown key, an axis without values,
/// lists of [zip] of different lengths, a key in two places, no setting that varies, more than `most_runs`. The program checks
/// whether the keys are parameters of a rule table.
[[nodiscard]] SweepFile read_sweep(const std::filesystem::path& path);

/// The settings of each cell: [[runs]] x [zip] x [grid], the last key of [grid] fastest, each with those of [set].
[[nodiscard]] std::vector<Settings> cells_of(const SweepFile& sweep);

/// "rules.capture.reach_m=0.5 rules.mutation.sd=0.1": those settings of a cell that are not in [set].
[[nodiscard]] std::string text_of(const Settings& cell, const SweepFile& sweep);

}  // namespace trophic::sweep
