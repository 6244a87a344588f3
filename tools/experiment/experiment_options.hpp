// SPDX-License-Identifier: MIT
// The options of an experiment's command line.
#pragma once

#include <functional>
#include <tools/command/read_parameters.hpp>
#include <tools/replicates/rewind.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/run/checkpoint/schedule.hpp>

namespace trophic::command {

/// Values from the command line. Missing ones come from the configuration file, then from the rule table.
struct ExperimentOptions {
  std::optional<std::string> rules;
  std::optional<std::string> backend;
  std::optional<std::uint64_t> seed;
  std::optional<double> duration_s;
  std::optional<std::uint64_t> robots;
  std::optional<std::string> robot;
  std::optional<std::uint64_t> threads;
  std::optional<std::uint64_t> replicates;
  std::optional<std::uint64_t> jobs;
  bool resume = false;
  bool accept_other_build = false;
  bool no_verify = false;
  std::string from;            ///< folder of the run that this one begins from
  std::optional<double> at_s;  ///< moment of that run
  double checkpoint_s = checkpoint::Schedule{}.every_s;
  bool shadow = false;
  bool neutral = false;
  bool clones = false;
  bool one_sided = false;
  std::string config;
  std::vector<std::string> assignments;
  std::string out;
  std::string save_mjcf;
  bool profile = false;
  bool live = false;                       ///< in a browser, which may steer it
  std::optional<std::uint64_t> live_port;  ///< of this machine; any free one otherwise
  std::string changes;                     ///< file of changes of parameters
  std::optional<std::uint64_t> replay_hz;
  std::uint64_t agents_every = 1;
  bool senses = false;
  bool states = false;
  bool print_config = false;
  std::string plan;                ///< file with a list of runs
  std::vector<std::uint64_t> run;  ///< numbers of its runs; empty: all of them
  bool status = false;             ///< of its runs
  bool describe = false;           ///< its runs, which are drafts
  bool print_table = false;
  std::string play;        ///< file of contests
  std::string signatures;  ///< file of genomes
  std::string program;     ///< as it was called
  io::Provenance provenance;
  io::OwnTables own_tables;  ///< the program's own tables, written by each run
};

/// The schedule that --checkpoint-s, --accept-other-build and --no-verify set.
[[nodiscard]] inline checkpoint::Schedule schedule_of(const ExperimentOptions& options) {
  using checkpoint::OtherBuild;
  return {.every_s = options.checkpoint_s,
          .other_build = options.accept_other_build ? OtherBuild::accepted : OtherBuild::refused,
          .verifies = !options.no_verify};
}

/// A run, and a moment of it at which others begin.
struct OriginRun {
  checkpoint::Moment moment;
  std::string rule_table;
  std::string engine;
  io::OutputOptions output;  ///< how much of it is written
  toml::table params;
  observe::RunDescription description;  ///< as this program makes it from these parameters
  /// Makes its state at the moment in a folder, as `replay_origin`.
  std::function<bool(const std::filesystem::path& folder)> make;
};

}  // namespace trophic::command
